#!/bin/sh
# Stands in for the `ldm` program where only what is around it counts: 10,000 trials that do nothing.
shift 2  # the data folder
case $1 in
  trials)
    echo '{"study": "nothing", "file": "nothing.toml", "frames": 10, "methods": {"m": "ldm"}, "files": {"nothing.toml": "0"}, "trials": ['
    seq -f '{"id": "w.m.s%05.0f"},' 9999
    echo '{"id": "w.m.s10000"}]}'
    ;;
  trial) for file; do :; done; echo '{"status": "ok"}' > "$file" ;;
esac
