#!/bin/bash
# Stands in for the `ldm` program: COUNT trials named t1, t2, ...; each takes SLEEP seconds. With NAMED set
# they are named w.old.t1, ..., or w.METHOD.t1, ...; a METHOD needs --plugin. They are made from the file INPUT,
# if it is set. Listing them takes LISTING seconds, and leaves a file LOG.listing.
# FAIL and CRASH name a trial that fails with a record, and one that dies without; END one that is asked to end,
# HANG one that never ends. EDIT names one before which INPUT is changed.
set -eu
plugin=
while [ "${1#--}" != "$1" ]; do
  [ "$1" = --plugin ] && plugin=$2
  [ "$1" = --data-dir ] && data=$2
  shift 2
done
command=$1 study=$2
name=${study##*/} name=${name%.toml}
shift 2
files() {
  hash=$(cat "${INPUT:-/dev/null}" | cksum)
  printf '{"%s": "%s"}' "${INPUT:-experiments/studies/fake.toml}" "$hash"
}
case $command in
  trials)
    method=old
    while [ $# -gt 0 ]; do
      case $1 in
        --seeds) COUNT=$2 ;;
        --frames) ;;
        --method) method=$2 ;;
        --json) break ;;
        *) echo "trials: $1" >&2; exit 2 ;;
      esac
      shift 2
    done
    [ "${LISTING:-}" ] && { touch "$LOG.listing"; sleep "$LISTING"; }
    [ "${UNKNOWN:-}" ] && { echo "unknown study" >&2; exit 2; }
    [ $method = old ] || [ "$plugin" ] || { echo "unknown method $method" >&2; exit 2; }
    printf '{"study": "%s", "file": "%s", "frames": 10, "methods": {"%s": "ldm"}, "files": %s, "trials": [' \
      "$name" "${INPUT:-experiments/studies/fake.toml}" $method "$(files)"
    seq -f "{\"id\": \"${NAMED:+w.$method.}t%.0f\"}," "${COUNT:-6}" | sed '$s/,$//'
    echo ']}'
    ;;
  trial)
    id=$1
    arguments="trial $study $*"
    while [ "$1" != -o ]; do shift; done
    record=$2
    part=${record%/*}/.$id.part.json
    if [ "${3:-}" = --failed ]; then
      printf '{"schema": 2, "status": "failed", "error": "%s", "id": "%s"}\n' "$4" "$id" > "$part"
      mv "$part" "$record"
      exit
    fi
    echo "$id" >> "$LOG"
    [ "$id" = "${EDIT:-}" ] && echo "edited" >> "$INPUT"
    echo '{"schema": 2,' > "$part"
    sleep "${SLEEP:-0}"
    if [ "$id" = "${CRASH:-}" ]; then
      kill -SEGV $$
    elif [ "$id" = "${END:-}" ]; then
      kill -TERM $$
    elif [ "$id" = "${HANG:-}" ]; then
      echo "waiting"
      sleep 1000
    elif [ "$id" = "${FAIL:-}" ]; then
      echo '{"schema": 2, "status": "failed", "error": "no path found"}' > "$record"
      rm "$part"
      exit 1
    fi
    echo "{\"schema\": 2, \"status\": \"ok\", \"arguments\": \"--data-dir $data $arguments\", \"files\": $(files)}" \
      > "$part"
    mv "$part" "$record" || { echo "$record: cannot be written" >&2; exit 1; }
    ;;
esac
