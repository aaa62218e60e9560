"""Figures of studies, recorded worlds and speeds, and the scripts that draw them."""
