# The only entry to this repository: `make` alone lists the targets. Needs GNU Make, bash, git, and apt
# for what is missing.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
MAKEFLAGS += --no-builtin-rules --no-print-directory
.SUFFIXES:

# Variables of the command line
STUDY    ?=
SEEDS    ?=
FRAMES   ?=
METHODS  ?= ldm
PLUGIN   ?=
FRESH    ?=
NATIVE   ?=
JOBS     ?= $(shell nproc)
RESULTS  ?= results
SLURM    ?=
SHARDS   ?= 4
CPUS     ?= 1
SBATCH_FLAGS ?=
REV      ?=
TRIAL_SECONDS ?=
FUZZ_SECONDS  ?= 600

# All of them stand between single quotes where a shell sees them; numbers are checked here, names where
# they are looked up.
define newline


endef
quote := '
digits := 0 1 2 3 4 5 6 7 8 9
erase = $(if $(1),$(call erase,$(wordlist 2,10,$(1)),$(subst $(firstword $(1)),,$(2))),$(2))
$(foreach name,STUDY METHODS PLUGIN RESULTS LDM REV STAGE,$(if $(findstring $(quote),$($(name)))$(findstring \
  $(newline),$($(name))),$(error $(name)=$($(name)): a quotation mark or line break is not allowed)))
$(foreach name,SEEDS FRAMES JOBS SHARDS CPUS TRIAL_SECONDS FUZZ_SECONDS,$(if $($(name)),$(if \
  $(or $(call erase,$(digits),$($(name))),$(if $(subst 0,,$($(name))),,0)),$(error \
  $(name)=$($(name)): a whole number of at least 1 is needed))))

BUILD := build$(if $(NATIVE),-native)
LDM   ?= $(BUILD)/bin/ldm
PYTHON := /usr/bin/python3
cxx_sources = git ls-files --cached --others --exclude-standard '*.h' '*.cpp'

.PHONY: help
help: ## list the targets
	@echo "Usage: make TARGET [VARIABLE=value ...]"; echo; \
	sed -n 's/^\([a-z-]*\):.*## \(.*\)/\1|\2/p' $(MAKEFILE_LIST) | while IFS='|' read -r target text; do \
	  printf '  %-15s %s\n' "$$target" "$$text"; done; \
	echo; sed -n 's/^#: //p' $(MAKEFILE_LIST)
#: Variables
#:   STUDY=name     which study             SEEDS=n   replicates, instead of the study's number
#:   FRAMES=n       shortened trials, kept apart in results/STUDY-fN
#:   FRESH=1        run all trials again    JOBS=n    processes at a time (default: all cores)
#:   METHODS="a b"  methods to compare      NATIVE=1  build for this very machine, in build-native/
#:   PLUGIN=FILE.so methods from outside, of a study or to compare: docs/variants.md
#:   SLURM=1        trials over Slurm, as an array of SHARDS=n (4) jobs with CPUS=n (1) each;
#:                  SBATCH_FLAGS="--time=2:00:00 ..." more options of sbatch: docs/studies.md
#:   TRIAL_SECONDS=n  after so long a trial is ended (default: a multiple of its estimate)
#:   RESULTS=folder instead of results/     LDM=path  a program that was built elsewhere
#:   STAGE=name     one stage of make conditions
#:   REV=revision   of git, to compare the speed with: docs/benchmarks.md
#:   FUZZ_SECONDS=n of each fuzzer (600)

# --- Set-up and build ------------------------------------------------------------------------------

# $(call install,LIST): what apt lacks of the packages in the file LIST.
define install
@wanted=$$(sed 's/#.*//' $(1)); \
if ! command -v apt-get >/dev/null; then \
  echo "setup: no apt on this system; install the equivalents of:" $$wanted >&2; exit 1; fi; \
present=$$(dpkg-query --show --showformat '$${db:Status-Abbrev}$${Package}\n' | sed -n 's/^ii //p'); \
missing=$$(comm -23 <(printf '%s\n' $$wanted | sort -u) <(sort -u <<< "$$present")); \
if [ -z "$$missing" ]; then exit 0; fi; \
echo "setup: installing" $$missing; \
as_root=; if [ "$$(id -u)" != 0 ]; then as_root=sudo; command -v sudo >/dev/null || { \
  echo "setup: not root and no sudo; as root: apt-get install" $$missing >&2; exit 1; }; fi; \
{ $$as_root apt-get update -q && $$as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends $$missing; } || { \
  echo "setup: apt-get failed; the packages are those of Debian 12" >&2; exit 1; }
endef

.PHONY: setup
setup: ## install the Debian packages that are missing (apt-packages.txt)
	$(call install,apt-packages.txt)

# A cache saves more than precompiled headers, and knows no sources that use them.
ccache = $$(command -v ccache >/dev/null && echo -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON)

# Configured once; afterwards CMake itself notices changed lists and new test files.
$(BUILD)/Makefile: | setup
	cmake -S . -B $(BUILD) --log-level=NOTICE -DCMAKE_BUILD_TYPE=Release $(if $(NATIVE),-DNATIVE=ON) \
	  $(ccache)

# $(call compile,TARGET): the outer Make's flags and variables are none of CMake's business.
compile = env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL \
  cmake --build $(BUILD) --parallel '$(JOBS)' --target $(1) | sed '/Built target/d'

.PHONY: build
build: $(BUILD)/Makefile ## build everything into build/
	@$(call compile,all)

# A program given as LDM=path is taken as it is.
.PHONY: program
ifeq ($(origin LDM),file)
program: $(BUILD)/Makefile ## build the program alone
	@$(call compile,ldm_program)
else
program:
endif

.PHONY: view
view: $(BUILD)/Makefile ## install and build what `ldm view` and films need: docs/pictures.md
	$(call install,apt-packages-view.txt)
	@cmake -S . -B $(BUILD) --log-level=NOTICE
	@$(call compile,ldm_program ldm_window)

# --- Tests and style -------------------------------------------------------------------------------

.PHONY: test
test: build ## run all tests: GoogleTest through ctest, then pytest
	@outcome=0; \
	ctest --test-dir $(BUILD) --output-on-failure --parallel $(JOBS) | tee $(BUILD)/ctest.log || outcome=1; \
	env -u MAKEFLAGS -u MFLAGS $(PYTHON) -m pytest tests | tee $(BUILD)/pytest.log || outcome=1; \
	echo; grep 'tests passed' $(BUILD)/ctest.log; tail -n 1 $(BUILD)/pytest.log; \
	exit $$outcome

.PHONY: test-slurm
test-slurm: program ## a study over a real Slurm of two nodes, one of which is lost: 4 minutes
	$(call install,tests/slurm/apt-packages.txt)
	@env -u MAKEFLAGS -u MFLAGS LDM='$(LDM)' $(PYTHON) -m pytest tests/slurm/lost_node.py

.PHONY: test-view
test-view: view ## the window of `ldm view` and films by ffmpeg, under a virtual screen: 1 minute
	$(call install,tests/view/apt-packages.txt)
	@env -u MAKEFLAGS -u MFLAGS LDM=$(BUILD)/bin/ldm $(PYTHON) -m pytest tests/view/window.py tests/view/film.py

.PHONY: test-scale
test-scale: program ## what a study of 10,000 trials costs beside its trials: docs/studies.md
	@$(PYTHON) tests/scale/ten_thousand_trials.py --program '$(LDM)' --jobs '$(JOBS)'

# The golden fingerprint of all particles and log-odds is among the tests of ldm/.
.PHONY: test-native
test-native: ## the tests of ldm/, built for this very machine: the same bits as the portable build
	@$(MAKE) NATIVE=1 test-ldm

.PHONY: test-ldm
test-ldm: $(BUILD)/Makefile
	@$(call compile,ldm_tests)
	@$(BUILD)/tests/ldm_tests --gtest_brief=1

.PHONY: test-old
test-old: $(BUILD)/Makefile ## the tests of ldm/ on an emulated x86 processor without AVX2, of 2008: the same bits
	$(if $(NATIVE),$(error test-old is for the portable build, without NATIVE=1))
	$(call install,tests/old/apt-packages.txt)
	@$(call compile,ldm_tests)
	@qemu-x86_64 -cpu Nehalem $(BUILD)/tests/ldm_tests --gtest_brief=1

.PHONY: test-arm
test-arm: BUILD = build-arm
test-arm: ## ldm/ and its tests, built for 64-bit ARM and run under an emulator: 4 minutes
	$(call install,tests/arm/apt-packages.txt)
	@cmake -S . -B $(BUILD) --log-level=NOTICE -DCMAKE_TOOLCHAIN_FILE=tests/arm/toolchain.cmake \
	  -DCMAKE_BUILD_TYPE=Release -DLDM_ALONE=ON -DWITH_TBB=OFF \
	  $(ccache)
	@$(call compile,all)
	@ctest --test-dir $(BUILD) --output-on-failure --parallel $(JOBS) \
	  | sed '/Passed\|^ *Start/d'

.PHONY: test-container
test-container: BUILD = build-container
test-container: ## the Dockerfile's steps, then `make smoke`, in a bare Debian below build-container/; as root
	$(call install,tests/container/apt-packages.txt)
	@$(PYTHON) tests/container/run_steps.py $(BUILD) make smoke

# Clang's runtime for fuzzing is not among the packages that building needs.
fuzz_targets = pcd trajectory kitti mrpt_log ros1_bag mcap_bag sqlite_bag kitti_raw pcap
.PHONY: fuzz
fuzz: setup ## fuzz the readers of recordings, each for FUZZ_SECONDS (600): docs/recordings.md
	$(call install,tests/fuzz/apt-packages.txt)
	@cmake -S . -B build-fuzz --log-level=NOTICE -DCMAKE_BUILD_TYPE=RelWithDebInfo -DFUZZ=ON \
	  -DBUILD_TESTING=OFF -DCMAKE_CXX_COMPILER=clang++-14
	@env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL cmake --build build-fuzz --parallel '$(JOBS)' \
	  --target $(fuzz_targets:%=fuzz_%) | sed '/Built target/d'
	@for target in $(fuzz_targets); do \
	  mkdir -p build-fuzz/corpus/$$target; \
	  build-fuzz/bin/fuzz_$$target -max_total_time=$(FUZZ_SECONDS) -timeout=60 -rss_limit_mb=4096 -malloc_limit_mb=8192 \
	    -artifact_prefix=build-fuzz/$$target- build-fuzz/corpus/$$target tests/fuzz/corpus/$$target || exit 1; \
	done

.PHONY: equations
equations: ## print where each equation of the paper is in plain words, in the fast code, and in a test
	@$(PYTHON) tests/equations.py

.PHONY: style
style: $(BUILD)/Makefile ## check layout (clang-format), and code but for experiments/ and tests/ (clang-tidy)
	$(cxx_sources) | xargs clang-format-14 --dry-run -Werror
	@cmake -S . -B $(BUILD) --log-level=NOTICE > /dev/null  # sources come and go
	@$(PYTHON) tests/tidy.py $(BUILD) --jobs '$(JOBS)'

.PHONY: format
format: setup ## lay out all C++ with clang-format
	$(cxx_sources) | xargs clang-format-14 -i

# --- Speed -----------------------------------------------------------------------------------------

.PHONY: bench
bench: $(BUILD)/Makefile ## speed of ours, bound, reference and baselines: results/bench.json, 2 to 4 minutes
	@$(call compile,ldm_bench ldm_kernels)
	@$(PYTHON) experiments/benchmarks/bench.py --program $(BUILD)/bin/ldm_bench \
	  --kernels $(BUILD)/bin/ldm_kernels --results '$(RESULTS)' $(if $(FRAMES),--frames '$(FRAMES)')
	@$(PYTHON) -m analysis.tables.bench_table --results '$(RESULTS)'
	@$(PYTHON) -m analysis.figures.bench_figures --results '$(RESULTS)'

.PHONY: bench-compare
bench-compare: $(BUILD)/Makefile ## time of the working tree over that of REV, both measured in turns
	@[ -n '$(REV)' ] || { echo "REV=revision is missing" >&2; exit 2; }
	@$(call compile,ldm_bench)
	@$(PYTHON) experiments/benchmarks/compare.py --revision='$(REV)' --program $(BUILD)/bin/ldm_bench \
	  $(if $(FRAMES),--frames '$(FRAMES)') $(if $(NATIVE),--native) --jobs '$(JOBS)'

# --- Studies ---------------------------------------------------------------------------------------

# $(call run_study,NAME). Times count only where trials run one after the other.
run_study = $(PYTHON) experiments/harness/run_study.py '$(1)' --program '$(LDM)' --results '$(RESULTS)' \
  --jobs '$(JOBS)' $(if $(filter timing,$(call stem,$(1))),--serial) $(if $(SEEDS),--seeds '$(SEEDS)') \
  $(if $(FRAMES),--frames '$(FRAMES)') $(if $(FRESH),--fresh) \
  $(if $(TRIAL_SECONDS),--trial-seconds '$(TRIAL_SECONDS)') $(slurm) $(foreach file,$(PLUGIN),--plugin '$(file)')
slurm = $(if $(SLURM),--shards '$(SHARDS)' --shard-cpus '$(CPUS)' --sbatch-flags='$(subst ','\'',$(SBATCH_FLAGS))')
# The program, of whatever build, with the scenarios of this tree.
program_here = '$(LDM)' --data-dir .
# Name of a study, which may be given as its file.
stem = $(basename $(notdir $(1)))
shortened = $(if $(FRAMES),-f$(FRAMES))
# $(call analyse,ROOM.SCRIPT,STUDY); the folder of a study's results is named as run_study.py does.
analyse = $(PYTHON) -m analysis.$(1) --results '$(RESULTS)' --study "$$(basename '$(2)' .toml)$(shortened)"

# Tables and figures of a study; those not named here are sweeps, ablations, or end as one.
scripts_table1 = tables.table1 figures.velocity_figures
scripts_velocity = tables.velocity figures.velocity_figures
scripts_timing = figures.computation_time
scripts_outdoor = figures.outdoor_figures
scripts_avoidance = figures.avoidance_figures
scripts_objects = tables.objects_table
scripts_objects_ablation = tables.objects_table
scripts_avoidance_trust = figures.avoidance_figures tables.trust_table
# Scores of a sweep, where they are not the usual ones.
shown_ghosts = --scores ghost_voxels_per_frame,seconds_to_clear,case1_visible_voxels,iou_visible
define draw
$(foreach script,$(or $(scripts_$(call stem,$(STUDY))),figures.sweep_figure),$(call \
  analyse,$(script),$(STUDY)) $(shown_$(call stem,$(STUDY))) && ) true
endef

# Lines of input, JOBS at a time: each in place of {}, or the words of each as arguments.
each = xargs -P '$(JOBS)' -I{}
# $(call note_origin,FOLDER): what captions say of recorded worlds and pictures, analysis/data/recorded.py.
note_origin = printf 'seed = 1\nprogram = "%s"\n' "$$('$(LDM)' --version)" > '$(1)'/recorded.toml
per_line = xargs -P '$(JOBS)' -L1

# Figure 5 needs a recorded world of each scenario, Figures 6 to 9 the records. Prints what it made.
worlds = $(RESULTS)/worlds$(shortened)
define draw_figures
mkdir -p '$(worlds)' && \
printf '%s\n' scenario1 scenario2 scenario3 | $(each) $(program_here) simulate {} --seed 1 \
  $(if $(FRAMES),--frames '$(FRAMES)') -o '$(worlds)/{}.rawlog' && \
$(call note_origin,$(worlds)) && \
$(call analyse,figures.figure5,worlds) && \
$(call analyse,figures.velocity_figures,table1)
endef

# Figures 11 to 13 need a recorded flight of each scenario, and pictures: of outdoor1 all at rest, walking,
# one hidden by another, and on the way back; of outdoor2 three on the way there and one on the way back.
# FRAMES does not shorten it. Prints what it made.
flight := $(RESULTS)/flight
flight_pictures := $(addprefix outdoor1.frame,60 112 136 205) $(addprefix outdoor2.frame,60 85 110 200)
define draw_flight
mkdir -p '$(flight)' && rm -f '$(flight)'/*.frame*.png && \
printf '%s\n' outdoor1 outdoor2 | $(each) $(program_here) simulate {} --seed 1 -o '$(flight)/{}.rawlog' && \
$(call note_origin,$(flight)) && \
for picture in $(flight_pictures); do printf 'ldm %s --seed 1 --set execution.threads=1 --frame %s -o "%s"\n' \
  $${picture%.*} $${picture#*.frame} '$(flight)'/$$picture.png; done | $(per_line) $(program_here) render && \
$(PYTHON) -m analysis.figures.flight_figures --results '$(RESULTS)'
endef

.PHONY: reproduce
reproduce: program ## the paper's studies: Table 1 and Figures 5 to 9, 11 to 16, ours beside the published
	@$(call run_study,table1)
	@$(call run_study,outdoor)
	@made=$$($(draw_figures)); outdoor=$$($(call analyse,figures.outdoor_figures,outdoor)); \
	$(call analyse,tables.table1,table1); \
	grep -v '\.\(png\|pdf\)$$' <<< "$$outdoor"; \
	echo "Pictures:"; grep -h 'png$$' <<< "$$made"$$'\n'"$$outdoor"
	@$(draw_flight) | grep 'png$$'

.PHONY: smoke
smoke: SEEDS = 2
smoke: FRAMES = 100
smoke: FRESH = 1
smoke: reproduce ## the path of `make reproduce` in a minute: 2 seeds of 100 frames

.PHONY: study
study: trials ## run the missing trials of STUDY=name, failed ones again; then its tables and figures
	@$(draw)

.PHONY: trials
trials: study-named program ## run the missing trials of STUDY=name, no more
	@$(call run_study,$(STUDY))

.PHONY: study-named
study-named:
	@[ -n '$(STUDY)' ] || { echo "STUDY=name is missing; 'make studies' lists them" >&2; exit 2; }

.PHONY: plot
plot: study-named setup ## tables and figures of STUDY=name, from the results that exist
	@$(draw)

.PHONY: studies
studies: program ## list the studies: number of trials, estimated time on JOBS cores
	@$(PYTHON) experiments/harness/list_studies.py --program '$(LDM)' --results '$(RESULTS)' \
	  --jobs '$(JOBS)' --serial timing

# A trial that fails (no room for a world) costs its condition alone.
conditions_stages := stage1 stage2a stage2b stage3
rank = $(PYTHON) -m analysis.conditions.rank
.PHONY: conditions
conditions: program ## under which conditions the paper's claims hold; STAGE=name runs one stage: docs/conditions.md
	@for stage in $(if $(STAGE),'$(STAGE)',$(conditions_stages)); do \
	  $(PYTHON) experiments/conditions/search.py "$$stage" --program '$(LDM)' --results '$(RESULTS)' \
	    --jobs '$(JOBS)' $(slurm) || [ $$? = 1 ] || exit 2; \
	  $(rank) "$$stage" --results '$(RESULTS)' || exit; \
	done
	@$(draw_conditions)
	@$(PYTHON) -m analysis.conditions.verdict_table '$(or $(STAGE),stage3)' --results '$(RESULTS)'

.PHONY: conditions-kept
conditions-kept: setup ## tables and figures of the search that is kept in the repository, without a trial
	@for stage in $(notdir $(wildcard analysis/conditions/kept/*)); do \
	  $(rank) $$stage --results '$(RESULTS)' --kept analysis/conditions/kept && \
	  $(PYTHON) -m analysis.conditions.verdict_table $$stage --results '$(RESULTS)' || exit; \
	done
	@$(draw_conditions)

# Of the same flights under three readings; the maps of one frame.
readings := ungated trilinear
mechanism := $(RESULTS)/conditions/mechanism
.PHONY: mechanism
mechanism: program ## why the paper's claims fail under other readings: two figures, half a minute
	@mkdir -p '$(mechanism)'
	@for world in outdoor1 scenario1; do \
	  $(program_here) simulate $$world --seed 1 --frames 240 -o '$(mechanism)'/$$world.rawlog > /dev/null; \
	  for reading in defaults $(readings); do echo $$world $$reading; done; done | $(per_line) bash -c '\
	    file=experiments/conditions/readings/$$2.toml; \
	    "$(LDM)" --data-dir . run ldm "$(mechanism)/$$1.rawlog" $$([ -f $$file ] && echo -c $$file) \
	      --save-frames 200 --save-as ply -o "$(mechanism)/$$2.$$1"' run > /dev/null
	@$(PYTHON) -m analysis.conditions.mechanism --results '$(RESULTS)' --readings $(readings) defaults --frame 200

define draw_conditions
$(PYTHON) -m analysis.conditions.claims_map --results '$(RESULTS)' && \
$(PYTHON) -m analysis.conditions.pair_map --results '$(RESULTS)'
endef

.PHONY: timing
timing: program ## computation time of each stage, trials one after the other
	@$(call run_study,timing)
	@$(call analyse,figures.computation_time,timing)

# Who hits what, where: one world flown by every arm. Prints what it made.
flights := $(RESULTS)/flights
flown_world := moving10_10
flown_seed := 1
arms := blind current_scan octomap circular_buffer circular_buffer_pf ldm object_ldm oracle oracle_future
define draw_flights
rm -rf '$(flights)' && mkdir -p '$(flights)' && \
printf '%s\n' $(arms) | $(each) $(program_here) fly {} $(flown_world) --seed $(flown_seed) \
  -o '$(flights)/{}' >/dev/null && \
$(PYTHON) -m analysis.figures.flown_world --results '$(RESULTS)'
endef

.PHONY: avoidance
avoidance: program ## the closed loop: who reaches the goal, upon which map: docs/avoidance.md
	@$(call run_study,avoidance)
	@$(call analyse,figures.avoidance_figures,avoidance)
	@$(draw_flights)

.PHONY: objects
objects: program ## objects a planner can trust: each goal and what is attained, and what brings it: docs/objects.md
	@$(call run_study,objects)
	@$(call run_study,objects_ablation)
	@$(call analyse,tables.objects_table,objects)
	@$(call analyse,tables.objects_table,objects_ablation)

.PHONY: object-figures
object-figures: program ## Figures 6 to 9 and 14 to 16 of object_ldm in place of the LDM, after make reproduce
	@for study in table1 outdoor; do $(MAKE) trials-of-objects STUDY=$$study || exit; done
	@$(call analyse,figures.velocity_figures,table1) --method object_ldm
	@$(call analyse,figures.outdoor_figures,outdoor) --method object_ldm

.PHONY: trials-of-objects
trials-of-objects: program
	@$(call run_study,$(STUDY)) --methods object_ldm

.PHONY: compare
compare: STUDY = table1
compare: program ## paired differences of METHODS="a b" against every other method of STUDY (table1)
	@$(call run_study,$(STUDY)) --methods '$(METHODS)'
	@$(call analyse,tables.compare,$(STUDY)) --methods '$(METHODS)'

.PHONY: tables
tables: setup ## Table 1 and the velocity errors, from the results that exist
	@$(call analyse,tables.table1,table1)

.PHONY: figures
figures: program ## Figures 5 to 9 and 11 to 16, from the results that exist
	@$(draw_figures)
	@$(draw_flight)
	@$(call analyse,figures.outdoor_figures,outdoor)

# The first frame from 20 s on in whose map scenario3 has a moving and a standing obstacle, and the one of
# outdoor1 in which people meet.
gallery_frame_outdoor1 := 112
.PHONY: gallery
gallery: program ## a picture of each scenario by each method, without a display: results/gallery/
	@mkdir -p '$(RESULTS)/gallery' && rm -f '$(RESULTS)'/gallery/*.png
	@{ $(foreach scenario,$(basename $(notdir $(wildcard datasets/scenarios/*.toml))), \
	  for method in $$('$(LDM)' methods | cut -d' ' -f1 | grep -v _without_); do \
	    printf '%s $(scenario) --frame $(or $(gallery_frame_$(scenario)),200) -o "%s"\n' \
	      $$method '$(RESULTS)/gallery/$(scenario)'.$$method.png; done;) } \
	  | $(per_line) $(program_here) render --seed 1
	@$(PYTHON) -m analysis.figures.gallery --results '$(RESULTS)'

# --- Report ----------------------------------------------------------------------------------------

include paper/paper.mk

# --- Cleaning --------------------------------------------------------------------------------------

.PHONY: clean
clean: ## delete what was built; results stay
	rm -rf build build-native build-fuzz build-arm build-rev build-container .pytest_cache
	git worktree prune 2>/dev/null || true  # without git there are none
	find analysis experiments tests -name __pycache__ -prune -exec rm -rf {} +

.PHONY: distclean
distclean: clean ## delete what was built, and all results
	rm -rf '$(RESULTS)'
