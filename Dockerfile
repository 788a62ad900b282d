FROM python:3.11-slim-bookworm AS build
RUN python -m venv /app/venv
COPY requirements.lock /build/
RUN /app/venv/bin/pip install --no-cache-dir --compile --require-hashes --requirement /build/requirements.lock
COPY pyproject.toml LICENSE /build/
COPY backend /build/backend
# The kernels' cache knows a source by its time, of which an image layer keeps whole seconds only.
RUN /app/venv/bin/pip install --no-cache-dir --compile --no-deps --no-build-isolation /build \
    && find /app/venv/lib/python3.11/site-packages/restitution -name '*.py' -exec touch --date=@1700000000 {} +

FROM python:3.11-slim-bookworm
RUN useradd --uid 10001 --user-group --no-create-home restitution \
    && install --directory --owner=restitution --group=restitution /app/cache
COPY --from=build /app/venv /app/venv
COPY frontend /app/frontend
ENV PATH=/app/venv/bin:$PATH \
    PYTHONUNBUFFERED=1 \
    NUMBA_CACHE_DIR=/app/cache \
    RESTITUTION_FRONTEND_DIRECTORY=/app/frontend
USER 10001:10001
# The cache must belong to the user that runs the server: hence after USER.
RUN restitution warm
EXPOSE 8000
HEALTHCHECK --interval=30s --timeout=3s --start-period=60s \
    CMD ["python", "-c", "__import__('urllib.request').request.urlopen('http://127.0.0.1:8000/healthz',timeout=2)"]
CMD ["restitution", "serve", "--host", "0.0.0.0", "--port", "8000"]
