# Another registry's copy of the same base: --build-arg PYTHON_IMAGE=…
ARG PYTHON_IMAGE=python:3.11.15-slim-bookworm

FROM ${PYTHON_IMAGE} AS build
# For strip alone. Not pinned: it stays behind in this stage, and a mirror keeps one version only.
# hadolint ignore=DL3008
RUN apt-get update && apt-get install --yes --no-install-recommends binutils \
    && rm -rf /var/lib/apt/lists/*
RUN python -m venv /app/venv
COPY requirements.lock /build/
RUN /app/venv/bin/pip install --no-cache-dir --compile --require-hashes --requirement /build/requirements.lock
COPY deploy/slim /build/
RUN /build/slim /app/venv
COPY requirements-docs.lock /build/
RUN python -m venv /guide \
    && /guide/bin/pip install --no-cache-dir --require-hashes --requirement /build/requirements-docs.lock
COPY pyproject.toml LICENSE README.md /build/
COPY backend /build/backend
COPY frontend /build/frontend
COPY docs /build/docs
COPY deploy /build/deploy
# Its tools stay behind in this stage; the installation below takes it into the package.
RUN PYTHONPATH=/build/backend:/app/venv/lib/python3.11/site-packages \
    /guide/bin/python /build/deploy/make_guide.py /build/build/guide
# The kernels' cache knows a source by its time, of which an image layer keeps whole seconds only.
RUN /app/venv/bin/pip install --no-cache-dir --no-compile --no-deps --no-build-isolation /build \
    && find /app/venv/lib/python3.11/site-packages/restitution -name '*.py' -exec touch --date=@1700000000 {} + \
    && /app/venv/bin/python -m compileall -q /app/venv/lib/python3.11/site-packages/restitution \
    && /app/venv/bin/pip uninstall --quiet --yes hatch-fancy-pypi-readme hatchling pathspec pluggy tomlkit trove-classifiers setuptools pip
COPY deploy/on-this-processor deploy/ready /app/
ENV NUMBA_CACHE_DIR=/app/cache
# Kernels for any processor and, if this one can run them, for those of the last ten years. A cache is
# its owner's alone, here for all to read.
RUN NUMBA_CPU_NAME=generic /app/venv/bin/restitution warm \
    && /app/on-this-processor --newer /app/venv/bin/restitution warm \
    && chmod --recursive a+rX /app/cache

FROM ${PYTHON_IMAGE}
LABEL org.opencontainers.image.title="Restitution" \
      org.opencontainers.image.description="Coefficient of tangential restitution of colliding frictional spheres: a page and a REST service" \
      org.opencontainers.image.licenses="MIT AND OFL-1.1"
# The base's own pip and setuptools: nothing is installed from here on.
RUN rm -rf /usr/local/lib/python3.11/site-packages/* /usr/local/lib/python3.11/ensurepip /usr/local/bin/pip* \
    && useradd --uid 10001 --user-group --no-create-home --home-dir /nonexistent --shell /usr/sbin/nologin restitution
COPY --from=build /app /app
ENV PATH=/app/venv/bin:$PATH \
    PYTHONUNBUFFERED=1 \
    PYTHONDONTWRITEBYTECODE=1 \
    NUMBA_CACHE_DIR=/app/cache
USER 10001:10001
EXPOSE 8000
HEALTHCHECK --interval=3s --timeout=3s --start-period=60s CMD ["/app/ready"]
ENTRYPOINT ["/app/on-this-processor"]
CMD ["restitution", "serve", "--host", "0.0.0.0", "--port", "8000"]
