# The report: `make paper`, and `make reproduce-full` for all that it rests on.

PAPER_STUDIES := table1 outdoor calibration timing ablation particles process_noise survival resolution map_size \
  sensor_noise channels obstacle_speed avoidance objects

.PHONY: paper
paper: setup ## the report paper/ldm-reproduction.pdf, from the results that exist
	$(call install,paper/apt-packages.txt)
	@mkdir -p paper/generated
	@$(PYTHON) tests/equations.py --json > paper/generated/equations.json
	@$(PYTHON) -m analysis.report --results '$(RESULTS)' --equations paper/generated/equations.json \
	  --output paper/generated
	@cd paper && latexmk -pdf -outdir=generated -silent -interaction=nonstopmode -halt-on-error \
	  ldm-reproduction.tex > generated/latexmk.out 2>&1 || { cat generated/latexmk.out; exit 1; }
	@! grep -E -A1 '^Overfull .hbox|undefined' paper/generated/ldm-reproduction.log >&2
	@mv paper/generated/ldm-reproduction.pdf paper/ && echo paper/ldm-reproduction.pdf

.PHONY: clean-paper
clean: clean-paper
clean-paper:
	rm -rf paper/generated paper/ldm-reproduction.pdf

.PHONY: reproduce-full
reproduce-full: SEEDS = 100
reproduce-full: program ## all that the report needs at 100 seeds, and the report; goes on where it stopped
	@$(PYTHON) experiments/harness/estimate.py $(PAPER_STUDIES) --program '$(LDM)' --results '$(RESULTS)' \
	  --seeds '$(SEEDS)' --jobs '$(JOBS)' --serial timing
	@for study in $(PAPER_STUDIES); do $(MAKE) trials STUDY=$$study SEEDS='$(SEEDS)' || exit; done
	@[ -e '$(RESULTS)/bench.json' ] || $(MAKE) bench
	@$(MAKE) figures paper SEEDS='$(SEEDS)'
