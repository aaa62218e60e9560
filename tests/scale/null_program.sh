#!/bin/sh
# Stands in for the `ldm` program where only what is around it counts: 10,000 trials that do nothing.
case $1 in
  trials) seq -f 'w.m.s%05.0f' 10000 ;;
  trial) for file; do :; done; echo '{"status": "ok"}' > "$file" ;;
esac
