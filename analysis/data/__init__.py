"""What the analysis reads: records, series, bench.json, the paper's numbers; statistics; command lines."""
