"""What a caption says of recorded worlds and pictures."""

from analysis.data.recorded import NAME, source


def test_files_alone_where_nothing_tells_of_them(tmp_path):
    assert source([tmp_path / "a.truth.csv", tmp_path / "b.truth.csv"]) == "Source: a.truth.csv, b.truth.csv."


def test_seed_and_commit_beside_them(tmp_path):
    program = "ldm 0.1.0 (commit 89227eb136778d1f45574ee84e408dca42f6920b, changed, binary 8396a9)"
    (tmp_path / NAME).write_text(f'seed = 1\nprogram = "{program}"\n')
    assert source([tmp_path / "a.png"]) == "Source: a.png, seed 1, commit 89227eb13677, changed."


def test_a_program_built_outside_of_git_has_no_commit(tmp_path):
    (tmp_path / NAME).write_text('seed = 1\nprogram = "ldm 0.1.0 (commit unknown, binary 8396a9)"\n')
    assert source([tmp_path / "a.png"]) == "Source: a.png, seed 1."
