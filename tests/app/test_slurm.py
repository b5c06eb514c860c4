# SPDX-License-Identifier: BSD-2-Clause
"""A sweep on a real Slurm with one or two nodes, with separate daemons, keys and ports."""
import csv
import os
import pathlib
import pty
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import time
import unittest

from soarbox_command import COMMAND, Run, end_with, free_port, wait_until
from mission_case import RULES, SWEEP, WORLD

DAEMONS = ("slurmctld", "slurmd", "munged", "sbatch", "squeue", "scancel")


def missing():
    paths = os.environ["PATH"] + ":/usr/sbin:/sbin"
    absent = [name for name in DAEMONS if not shutil.which(name, path=paths)]
    if absent:
        return "Slurm is not installed here: " + ", ".join(absent)
    return "Slurm's daemons want to be started by root" if os.geteuid() != 0 else ""


class SlurmCase(unittest.TestCase):
    """Starts a Slurm for each test. Each node is a daemon on this host."""
    nodes = None  # The names of the nodes; None: one node, named like the host.

    def setUp(self):
        folder = tempfile.TemporaryDirectory(dir="/tmp")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        os.chmod(self.folder, 0o755)
        os.environ["PATH"] += ":/usr/sbin:/sbin"
        host = socket.gethostname().split(".")[0]
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        sock = self.folder / "munge.sock"
        conf = self.folder / "slurm.conf"
        processors = len(os.sched_getaffinity(0))
        names = self.nodes or [host]
        lines = "\n".join(f"NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={free_port()} CPUs={max(1, processors // len(names))} "
                          "RealMemory=1000 State=UNKNOWN" for name in names)
        conf.write_text(f"""
ClusterName=here
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={free_port()}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={sock}
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
ReturnToService=2
StateSaveLocation={self.folder}/state
SlurmdSpoolDir={self.folder}/spool-%n
SlurmctldPidFile={self.folder}/slurmctld.pid
SlurmdPidFile={self.folder}/slurmd-%n.pid
SlurmctldLogFile={self.folder}/slurmctld.log
SlurmdLogFile={self.folder}/slurmd-%n.log
SlurmdTimeout=5
SchedulerParameters=sched_interval=1
MinJobAge=5
MaxArraySize=8
{lines}
PartitionName=all Nodes={",".join(names)} Default=YES MaxTime=INFINITE State=UP
""", encoding="utf-8")
        (self.folder / "state").mkdir()
        for name in names:
            (self.folder / f"spool-{name}").mkdir()
        os.environ["SLURM_CONF"] = str(conf)
        self.addCleanup(os.environ.pop, "SLURM_CONF")
        self.daemons = []
        self.addCleanup(self.stop)
        self.start("munged", "--foreground", "--force", "--key-file", key, "--socket", sock, "--log-file", self.folder / "munge.log",
                   "--pid-file", self.folder / "munge.pid", "--seed-file", self.folder / "munge.seed")
        self.wait(sock.exists)
        self.start("slurmctld", "-D", "-f", conf)
        for name in names:
            self.start("slurmd", "-D", "-f", conf, "-N", name)
        self.wait(lambda: self.slurm("sinfo", "-h", "-N", "-o", "%T").split() == ["idle"] * len(names))

    def slurm(self, *words):
        return subprocess.run(words, capture_output=True, text=True, check=False).stdout

    def start(self, *words):
        with open(self.folder / (words[0] + ".out"), "wb") as out:
            self.daemons.append(subprocess.Popen(list(map(str, words)), stdout=out, stderr=out))

    def stop(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def wait(self, condition, limit_s=60):
        end = time.monotonic() + limit_s
        while not condition():
            if time.monotonic() > end:
                texts = [path.read_text(errors="replace")[-2000:] for path in self.folder.glob("*.out")]
                self.fail("Slurm did not come up: " + "\n".join(texts))
            time.sleep(0.2)

    def rows(self, folder):
        with open(folder / "results.csv", newline="", encoding="utf-8") as file:
            return [{key: value for key, value in row.items() if key not in ("cpu_s", "peak_mb", "host", "tries")} for row in csv.DictReader(file)]

    def sweep_of(self, seeds):
        (self.folder / "scenario.toml").write_text(WORLD, encoding="utf-8")
        (self.folder / "scout.soar").write_text(RULES, encoding="utf-8")
        spec = self.folder / "sweep.toml"
        spec.write_text(SWEEP.replace("1..6", seeds), encoding="utf-8")
        return spec


@unittest.skipIf(missing(), missing())
class OnSlurm(SlurmCase):
    def test_a_job_array_with_a_task_killed_comes_to_the_local_table(self):
        (self.folder / "scenario.toml").write_text(WORLD, encoding="utf-8")
        (self.folder / "scout.soar").write_text(RULES, encoding="utf-8")
        spec = self.folder / "sweep.toml"
        spec.write_text(SWEEP.replace("1..6", "1..100"), encoding="utf-8")
        there = self.folder / "there"

        def kill_one():
            # A task is stopped in the middle: its finished runs stay, the others are assigned again.
            for entry in pathlib.Path("/proc").glob("[0-9]*"):
                try:
                    words = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
                except OSError:
                    continue
                if str(there) in words and "--task" in words and any((there / "parts").glob("*.rows")):
                    os.kill(int(entry.name), signal.SIGKILL)
                    return True
            return False

        killer = threading.Thread(target=wait_until, args=(kill_one, "a task at work"))
        killer.start()
        run = Run("sweep", spec, "--folder", there, "--on", "slurm", "--tasks", "3")
        killer.join()
        self.assertEqual(run.code, 0, run.out + run.err)
        self.assertEqual(Run("sweep", spec, "--folder", self.folder / "here").code, 0)
        rows = self.rows(there)
        self.assertEqual(len(rows), 200)
        self.assertEqual(rows, self.rows(self.folder / "here"))

    def on_a_terminal(self, *words):
        """The command with its error output on a terminal, because progress is only shown there."""
        ours, its = pty.openpty()
        process = subprocess.Popen([COMMAND, *map(str, words)], stdout=subprocess.DEVNULL, stderr=its)
        os.close(its)
        end_with(self, process)
        self.shown = ""

        def read():
            while True:
                try:
                    piece = os.read(ours, 65536)
                except OSError:
                    piece = b""
                if not piece:
                    os.close(ours)
                    return
                self.shown += piece.decode(errors="replace")

        reader = threading.Thread(target=read)
        reader.start()
        self.addCleanup(reader.join)
        return process

    def wait_until_shown(self, pattern, limit_s=60):
        wait_until(lambda: re.search(pattern, self.shown), pattern, limit_s)

    def test_who_waits_sees_how_far_it_is_and_that_slurm_is_away(self):
        there = self.folder / "there"
        process = self.on_a_terminal("sweep", self.sweep_of("1..150"), "--folder", there, "--on", "slurm")
        self.wait_until_shown(r"\r\d+ of 300 runs, [\d.]+ per second, \d+ s to go")
        controller = self.daemons[1]
        os.kill(controller.pid, signal.SIGTERM)
        controller.wait(30)
        self.wait_until_shown(r"Slurm does not answer: .*; still waiting")
        self.assertIsNone(process.poll(), "the jobs run on, and it waits for them")
        self.start("slurmctld", "-D", "-f", os.environ["SLURM_CONF"])
        # On a busy machine all runs may have ended before the controller has restarted.
        wait_until(lambda: "Slurm answers again" in self.shown or process.poll() is not None, "an answer")
        self.assertEqual(process.wait(120), 0, self.shown)
        counts = [int(number) for number in re.findall(r"\r(\d+) of 300 runs", self.shown)]
        self.assertEqual(counts, sorted(counts))
        self.assertEqual(len(self.rows(there)), 300)

    def test_more_tasks_than_an_array_may_have_become_larger_ones(self):
        there = self.folder / "there"
        run = Run("sweep", self.sweep_of("1..4"), "--folder", there, "--on", "slurm", "--tasks", "64", code=0)
        self.assertIn("Slurm takes at most 8 tasks in an array here (MaxArraySize): 64 become 8", run.err)
        self.assertEqual(len(self.rows(there)), 8)

    def test_a_node_that_is_drained_is_named_while_somebody_waits(self):
        there, host = self.folder / "there", socket.gethostname().split(".")[0]
        def node(state):
            subprocess.run(["scontrol", "update", f"NodeName={host}", f"State={state}", "Reason=cleaning"], check=True)
        node("DRAIN")
        process = self.on_a_terminal("sweep", self.sweep_of("1..2"), "--folder", there, "--on", "slurm")
        self.wait_until_shown(r"Slurm holds the jobs back: .*; squeue and sinfo --list-reasons say more")
        self.assertIsNone(process.poll())
        node("RESUME")
        self.assertEqual(process.wait(120), 0, self.shown)
        self.assertEqual(len(self.rows(there)), 4)

    def test_what_a_task_needs_is_passed_on(self):
        there, kept = self.folder / "there", self.folder / "comment"
        # Slurm uses the last of two equal options, so the output file shows that this one was passed on.
        run = Run("sweep", self.sweep_of("1..2"), "--folder", there, "--on", "slurm", "--sbatch=--cpus-per-task=1",
                  "--sbatch=--mem=200M", "--sbatch=--time=5", f"--sbatch=--output={kept}", code=0)
        self.assertTrue(kept.is_file(), run.err)
        self.assertIn("4 runs made", kept.read_text(encoding="utf-8"))
        wrong = Run("sweep", self.sweep_of("1..2"), "--folder", self.folder / "other", "--on", "slurm", "--sbatch=--mem=much", code=3)
        self.assertIn("Slurm did not accept the job", wrong.err)

    def test_who_waits_for_a_job_that_is_cancelled_is_told_and_continues_later(self):
        there = self.folder / "there"
        spec = self.sweep_of("1..100")
        process = self.on_a_terminal("sweep", spec, "--folder", there, "--on", "slurm")
        self.wait_until_shown(r"\r[1-9]\d* of 200 runs")
        self.assertEqual(Run("sweep", spec, "--folder", there, "--cancel").code, 0)
        self.assertEqual(process.wait(60), 3, self.shown)
        self.wait_until_shown(r"job \d+ was cancelled")
        self.assertNotIn("given to Slurm again", self.shown)
        run = Run("sweep", spec, "--folder", there, "--cancel", code=3)
        self.assertIn("was not given to Slurm", run.err)
        made = len(list((there / "parts").glob("*.rows")))
        self.assertGreater(made, 0)
        run = Run("sweep", spec, "--folder", there, code=0)
        self.assertRegex(run.err, r"[1-9]\d* were there")
        self.assertEqual(len(self.rows(there)), 200)


@unittest.skipIf(missing(), missing())
class OnTwoNodes(SlurmCase):
    nodes = ("one", "two")

    def processes_of(self, node):
        """The processes of this node except its daemon: steps and tasks."""
        found = []
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                environment = (entry / "environ").read_bytes().split(b"\0")
            except OSError:
                continue
            if f"SLURMD_NODENAME={node}".encode() in environment and f"SLURM_CONF={os.environ['SLURM_CONF']}".encode() in environment:
                found.append(int(entry.name))
        return found

    def lose(self, node):
        """Simulates a power failure of a node: kills its daemon and all its processes at once."""
        self.daemons[-1 if node == self.nodes[-1] else -2].kill()
        for process in self.processes_of(node):
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def test_two_nodes_share_the_work_and_one_that_is_lost_leaves_it_to_the_other(self):
        spec, there = self.sweep_of("1..40"), self.folder / "there"
        process = subprocess.Popen([COMMAND, "sweep", spec, "--folder", there, "--on", "slurm", "--tasks", "4"], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        end_with(self, process)
        def both_work():
            return set(self.slurm("squeue", "-h", "-t", "running", "-o", "%N").split()) == set(self.nodes) and \
                len(list((there / "parts").glob("*.rows"))) >= 2
        wait_until(both_work, "both nodes at work")
        self.lose("two")
        wait_until(lambda: "down" in self.slurm("sinfo", "-h", "-n", "two", "-o", "%T") or process.poll() is not None, "Slurm sees the loss")
        _, err = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 0, err)
        self.assertEqual(len(self.rows(there)), 80)
        Run("sweep", spec, "--folder", self.folder / "here", code=0)
        self.assertEqual(self.rows(there), self.rows(self.folder / "here"))
