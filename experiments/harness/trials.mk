# The rule behind `make study`: one trial = one record = one target. Called by experiments/harness/run_study.py with
#   PROGRAM  the `ldm` program           STUDY    name of the study     OPTIONS  options of `ldm trial`
#   RECORDS  folder of the records       TODO     file, one trial id a line
# A record that exists is not made again. A trial that fails still makes its target, a record that says
# so: the rule succeeds, and run_study.py counts. Prints one line per finished trial. A trial that was asked to
# end (SIGHUP, SIGINT, SIGTERM: a job cancelled or out of time) has not failed: it makes no record.

here := $(dir $(lastword $(MAKEFILE_LIST)))
# /bin/sh starts in a third of bash's time, which counts when trials are short.
SHELL := /bin/sh
MAKEFLAGS += --no-builtin-rules --no-builtin-variables --no-print-directory
.SUFFIXES:

records := $(patsubst %,$(RECORDS)/%.json,$(file < $(TODO)))
trial = $(PROGRAM) trial $(STUDY) $* $(OPTIONS) -o $@

.PHONY: trials
trials: $(records)
# A record appears complete, under its final name: no reason to delete it on Ctrl-C.
.PRECIOUS: $(records)

# The braces keep the shell's own word on a crash off the screen: the record has it.
$(records): $(RECORDS)/%.json:
	@{ output=$$($(trial) 2>&1); code=$$?; } 2>/dev/null; \
	if [ $$code = 0 ] && [ -s $@ ]; then echo good; exit; fi; \
	case $$code in 129|130|143) exit 1;; esac; \
	[ -s $@ ] || printf '%s' "$$output" | /usr/bin/python3 $(here)crash_record.py $@ \
	  --exit-code $$code --study $(STUDY) --id $* --command '$(trial)' || exit 1; \
	echo failed
