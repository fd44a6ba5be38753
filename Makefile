PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/.installed
INSTALLED_DOCS := $(VENV)/.installed-docs

# compiled modules are kept between processes, also where the environment forbids it: compiling all of them takes each
# process 2 s
unexport PYTHONDONTWRITEBYTECODE

.PHONY: install release-check benchmarks demo test test-step test-gpu browsers check format page docs docs-all docs-links validation walk clean

install: $(INSTALLED_DOCS)  ## install all that the targets below need

demo: $(INSTALLED)  ## fold and open the reference wing; results in out/binder2025/
	$(BIN)/forficula run binder2025 --out out/binder2025

test: $(INSTALLED)  ## run all tests; the next make docs shows those of validation
	mkdir -p docs/_build
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest -n auto --junitxml=docs/_build/validation.xml  # one thread for each worker

test-step: $(INSTALLED)  ## before a release: install Open Cascade, 380 MB, and compare all solids with it
	$(BIN)/python -m pip install --quiet --editable ".[step]"
	FORFICULA_STEP=demanded $(BIN)/python -m pytest -n 0 tests/make/test_step.py

test-gpu: $(INSTALLED)  ## before a release: install MuJoCo Warp, 370 MB, and test it on its device "warp-cpu"
	$(BIN)/python -m pip install --quiet --editable ".[gpu]"
	FORFICULA_GPU=demanded $(BIN)/python -m pytest -n 0 tests/dynamics/test_gpu.py

browsers: $(INSTALLED)  ## open every kind of page in Firefox, which must be installed; before a release
	FORFICULA_EVERY_BROWSER=1 FORFICULA_NEED_FIREFOX=1 $(BIN)/python -m pytest \
		tests/show/page/test_pages_in_firefox.py tests/show/page/test_live_wing.py

check: $(INSTALLED)  ## lint, types, layers, words
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/python docs/check_language.py

format: $(INSTALLED)
	$(BIN)/ruff check --fix
	$(BIN)/ruff format

page:  ## build the script of the HTML pages, which is kept in the package; needs Node.js
	cd web && npm ci && npm run build

benchmarks: $(INSTALLED)  ## run every benchmark in its smallest size, as a check
	$(BIN)/python benchmarks/advice.py --designs 1 --family joint
	$(BIN)/python benchmarks/confirmation.py --of binder2025-joint --designs 1
	$(BIN)/python benchmarks/contact.py --units 1 --strips 1 --sheets "two panels"
	$(BIN)/python benchmarks/fan_fits.py --fans 2
	$(BIN)/python benchmarks/folding_ratio.py --units 1
	$(BIN)/python benchmarks/gpu.py --smallest
	$(BIN)/python benchmarks/identify.py --plantings 1 --only smooth
	$(BIN)/python benchmarks/many_points.py --points 1000 --shards 2
	$(BIN)/python benchmarks/named_designs.py letter-fold
	$(BIN)/python benchmarks/optimise.py --runs 4 --batch 4 --seeds 1 --only methods --goals wing joint
	$(BIN)/python benchmarks/screening.py --repetitions 1
	$(BIN)/python benchmarks/search.py --points 1 --full --plain 1 --wings 2 --rounds 1
	$(BIN)/python benchmarks/shards.py --points 120 --shards 24
	$(BIN)/python benchmarks/sheets.py --most 2
	$(BIN)/python benchmarks/size.py --short
	$(BIN)/python benchmarks/slow_ramps.py --fans 1
	$(BIN)/python benchmarks/timestep.py --designs 1
	$(BIN)/python benchmarks/tracing.py --small --pictures 2 --only pleats fan

docs: $(INSTALLED_DOCS)  ## build the documentation into docs/_build/html; this runs everything that it shows
	$(BIN)/python -m sphinx -W --keep-going -q -j 2 -d docs/_build/doctrees docs docs/_build/html
	$(BIN)/python docs/check_pages.py docs/_build/html

docs-all:  ## the same with the study beside the paper, which takes minutes
	FORFICULA_DOCS=all $(MAKE) docs

docs-links: $(INSTALLED_DOCS)  ## check the links of the documentation to other hosts
	mkdir -p docs/_build
	-$(BIN)/python -m sphinx -q -b linkcheck -d docs/_build/doctrees docs docs/_build/links >docs/_build/links.log 2>&1
	$(BIN)/python docs/check_links.py docs/_build/links/output.json

release-check: $(INSTALLED)  ## before a release: build the packages into dist/, install and use them with three Pythons
	$(BIN)/python release/check.py

walk:  ## run the commands of README and tutorial, word for word, in a clean clone with an empty environment
	$(PYTHON) docs/walk.py

validation: $(INSTALLED)  ## run the validation tests; the next make docs shows them
	mkdir -p docs/_build
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest -n auto tests/validation --junitxml=docs/_build/validation.xml

clean:
	rm -rf $(VENV) out docs/_build docs/gallery

# uv needs 10 s, pip 50 s; pip is used if uv is missing or finds no packages
define install_groups
	$(PYTHON) -m venv $(VENV)
	($(BIN)/python -m pip install --quiet uv && \
		$(BIN)/uv pip install --quiet --python $(BIN)/python --editable . $(1)) || \
		($(BIN)/python -m pip install --quiet --upgrade "pip>=25.1" && \
		$(BIN)/python -m pip install --quiet --editable . $(1))
endef

$(INSTALLED): pyproject.toml
	$(call install_groups,--group dev)
	touch $@

# one call resolves and installs both groups together
$(INSTALLED_DOCS): pyproject.toml
	$(call install_groups,--group dev --group docs)
	touch $(INSTALLED) $@
