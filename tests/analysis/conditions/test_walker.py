"""The walker's figure: what it draws, and what it refuses."""

import pytest
from analysis.conditions import walker
from analysis.data.errors import InputError
from record_files import make_record, make_series, write_record


def record(folder, name, series):
    return write_record(folder, make_record(scenario="outdoor1", series=series, id=name))


def test_it_draws_the_first_walker_of_each_record(tmp_path, capsys):
    frames = list(range(300))
    standing = make_series(1, False, frames)
    steady = record(tmp_path, "a", [standing, make_series(2, True, frames, 0.01)])
    shaky = record(tmp_path, "b", [standing, make_series(3, True, frames, 0.2)])
    walker.main(["--results", str(tmp_path), "--records", f"steady={steady}", f"shaky={shaky}"])
    assert "walker.png" in capsys.readouterr().out
    assert (tmp_path / "conditions" / "figures" / "walker.png").stat().st_size > 10_000


@pytest.mark.parametrize("text", ["no-file", "name={none}"])
def test_a_record_without_a_walker_or_a_name_is_refused(tmp_path, text):
    none = record(tmp_path, "c", [make_series(1, False, [0, 1])])
    with pytest.raises(InputError):
        walker.main(["--records", text.format(none=none)])
