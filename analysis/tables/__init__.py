"""Tables of a study, ours beside the paper's, and the scripts that write them."""
