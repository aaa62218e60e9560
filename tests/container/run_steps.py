"""Run a Dockerfile's steps in a bare Debian root, where no container engine is at hand; as root.

    run_steps.py ROOT [COMMAND]    COMMAND in place of the Dockerfile's CMD

ROOT is made by debootstrap if it is missing. The Dockerfile is that of this repository, and may use the
instructions below. What is mounted vanishes with the step that needs it: ROOT can be deleted at any time.
"""

import json
import shlex
import shutil
import subprocess
import sys
from fnmatch import fnmatch
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
# A new system of mounts and processes for each step, as a container has.
ENTER = """mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" && cp /etc/resolv.conf "$1/etc" &&
exec chroot "$1" env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
/bin/sh -c 'cd "$1" && exec /bin/sh -c "$2"' sh "$2" "$3" """


def run(root: Path, folder: str, command: str) -> None:
    print(f"--- {command}", flush=True)
    subprocess.run(["unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-c", ENTER, "sh",
                    str(root), folder, command], check=True)


def ignored(folder: str, names: list[str]) -> set[str]:
    """For copytree: what .dockerignore excludes, by its patterns from the top or, with **/, at any depth."""
    patterns = (SOURCE / ".dockerignore").read_text().split()
    paths = {name: str((Path(folder) / name).relative_to(SOURCE)) for name in names}
    return {name for name, path in paths.items() for pattern in patterns
            if fnmatch(path, pattern) and path.count("/") == pattern.count("/")
            or pattern.startswith("**/") and fnmatch(name, pattern[3:])}


def main(root: Path, command: str | None) -> None:
    folder = "/"
    lines = (SOURCE / "Dockerfile").read_text().replace("\\\n", " ").splitlines()
    for line in [line for line in lines if line and not line.startswith("#")]:
        instruction, words = line.split(maxsplit=1)
        if instruction == "FROM":
            suite = words.removeprefix("debian:")
            if not root.exists():
                subprocess.run(["debootstrap", "--variant=minbase", suite, root], check=True)
            assert f"VERSION_CODENAME={suite}\n" in (root / "etc/os-release").read_text(), f"not {words}: {root}"
        elif instruction == "WORKDIR":
            folder = words
        elif instruction == "COPY" and words == ". ." and folder != "/":
            shutil.rmtree(root / folder[1:], ignore_errors=True)  # of an earlier run
            shutil.copytree(SOURCE, root / folder[1:], symlinks=True, ignore=ignored)
        elif instruction == "RUN":
            run(root, folder, words)
        elif instruction == "CMD":
            run(root, folder, command or shlex.join(json.loads(words)))
        else:
            sys.exit(f"run_steps.py: unknown: {line}")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), shlex.join(sys.argv[2:]))
