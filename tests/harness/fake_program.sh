#!/bin/bash
# Stands in for the `ldm` program: COUNT trials named t1, t2, ...; each takes SLEEP seconds. With NAMED set
# they are named w.old.t1, ..., or w.METHOD.t1, ...; a METHOD needs --plugin.
# FAIL and CRASH name a trial that fails with a record, and one that dies without; END one that is asked to end.
set -eu
case $1 in
  trials)
    shift 2
    method=old
    while [ $# -gt 0 ]; do
      case $1 in
        --seeds) COUNT=$2 ;;
        --frames) ;;
        --method) method=$2 ;;
        --plugin) plugin=$2 ;;
        *) echo "trials: $1" >&2; exit 2 ;;
      esac
      shift 2
    done
    [ "${UNKNOWN:-}" ] && { echo "unknown study" >&2; exit 2; }
    [ $method = old ] || [ "${plugin:-}" ] || { echo "unknown method $method" >&2; exit 2; }
    seq -f "${NAMED:+w.$method.}t%.0f" "${COUNT:-6}"
    ;;
  trial)
    id=$3
    record=${!#}
    echo "$id" >> "$LOG"
    echo '{"schema": 1,' > "$record.part"
    sleep "${SLEEP:-0}"
    if [ "$id" = "${CRASH:-}" ]; then
      kill -SEGV $$
    elif [ "$id" = "${END:-}" ]; then
      kill -TERM $$
    elif [ "$id" = "${FAIL:-}" ]; then
      echo '{"schema": 1, "status": "failed", "error": "no path found"}' > "$record"
      exit 1
    fi
    echo "{\"schema\": 1, \"status\": \"ok\", \"arguments\": \"$*\"}" > "$record.part"
    mv "$record.part" "$record"
    ;;
esac
