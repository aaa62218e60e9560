"""A real Slurm of two nodes on this machine, for tests: daemons of its own, started by hand."""

import getpass
import os
import secrets
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
NODES = ("n1", "n2")


class Cluster:
    """Starts the daemons; `stop` ends them and all they started, and deletes their files."""

    def __init__(self) -> None:
        # Not below pytest's own folder: munge demands that all may enter the folder of its socket.
        self._folder = Path(tempfile.mkdtemp(prefix="slurm-"))
        self._folder.chmod(0o755)
        for name in ("state", *(f"spool.{node}" for node in NODES)):
            (self._folder / name).mkdir()
        self.environment = os.environ | {"SLURM_CONF": str(self._write_configuration())}
        try:
            self._start_munge()
            self._run("slurmctld")
            for node in NODES:
                # Its descendants inherit the mark, by which `processes` finds them.
                self._run("slurmd", "-N", node, SLURMD_NODENAME=node)
            self._wait_until_idle()
        except BaseException:
            self.stop()
            raise

    def _write_configuration(self) -> Path:
        text = (HERE / "slurm.conf.in").read_text(encoding="utf-8")
        values = {"HOST": socket.gethostname().partition(".")[0], "USER": getpass.getuser(),
                  "FOLDER": str(self._folder)}
        ports = ("CONTROLLER_PORT", "N1_PORT", "N2_PORT")
        for name, value in (values | dict(zip(ports, free_ports(len(ports))))).items():
            text = text.replace(f"@{name}@", value)
        file = self._folder / "slurm.conf"
        file.write_text(text, encoding="utf-8")
        return file

    def _start_munge(self) -> None:
        key = self._folder / "munge.key"
        key.touch(mode=0o600)
        key.write_bytes(secrets.token_bytes(1024))
        names = {"key-file": "key", "socket": "socket", "pid-file": "pid", "log-file": "log",
                 "seed-file": "seed"}
        self._run("munged", *(f"--{option}={self._folder}/munge.{name}" for option, name in names.items()))

    def _run(self, *command: str, **environment: str) -> str:
        """Output of a command; a daemon goes to the background by itself."""
        # The administrator's programs are not on everyone's path.
        program = shutil.which(command[0], path=f"{os.environ['PATH']}:/usr/sbin:/sbin")
        if program is None:
            raise FileNotFoundError(f"{command[0]}: not installed")
        with tempfile.TemporaryFile("w+") as output:  # no pipe: a daemon would keep it open
            done = subprocess.run([program, *command[1:]], env=self.environment | environment,
                                  stdout=output, stderr=subprocess.STDOUT, check=False)
            output.seek(0)
            text = output.read()
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(command)}: exit code {done.returncode}: {text}")
        return text

    def _wait_until_idle(self) -> None:
        deadline = time.monotonic() + 60
        while self._run("sinfo", "-h", "-t", "idle", "-o", "%D").split() != [str(len(NODES))]:
            if time.monotonic() > deadline:
                raise TimeoutError(self._run("sinfo", "-N", "-l"))
            time.sleep(0.2)

    def processes(self, node: str | None = None) -> list[int]:
        """All processes of the cluster, or those of one node: daemon, job steps, trials."""
        marks = {f"SLURM_CONF={self.environment['SLURM_CONF']}".encode()}
        if node:
            marks.add(f"SLURMD_NODENAME={node}".encode())
        found = []
        for entry in Path("/proc").iterdir():
            try:
                if entry.name.isdigit() and marks <= set((entry / "environ").read_bytes().split(b"\0")):
                    found.append(int(entry.name))
            except OSError:  # it has ended, or is another user's
                continue
        return found

    def running_trials(self, node: str) -> list[int]:
        """Processes of the trials that a node runs now."""
        return [process for process in self.processes(node) if command_line(process)[3:4] == ["trial"]]

    def kill(self, node: str) -> None:
        """A node loses its power: first nothing of it moves, then nothing is left."""
        self._signal(node, signal.SIGSTOP)
        self._signal(node, signal.SIGKILL)

    def _signal(self, node: str | None, number: signal.Signals) -> None:
        for process in self.processes(node):
            try:
                os.kill(process, number)
            except ProcessLookupError:
                continue

    def node_states(self) -> dict[str, str]:
        return dict(line.split() for line in self._run("sinfo", "-h", "-N", "-o", "%N %t").splitlines())

    def jobs(self) -> list[str]:
        """Numbers of the jobs that wait or run."""
        return sorted(set(self._run("squeue", "-h", "-o", "%F").split()))

    def stop(self) -> None:
        self._signal(None, signal.SIGKILL)
        shutil.rmtree(self._folder, ignore_errors=True)


def command_line(process: int) -> list[str]:
    """Its words; none if it has ended."""
    try:
        return Path(f"/proc/{process}/cmdline").read_text(encoding="utf-8").split("\0")
    except OSError:
        return []


def free_ports(count: int) -> list[str]:
    """Ports of this machine that nobody listens on now."""
    listeners = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    numbers = [str(listener.getsockname()[1]) for listener in listeners]
    for listener in listeners:
        listener.close()
    return numbers
