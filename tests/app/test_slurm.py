# SPDX-License-Identifier: BSD-2-Clause
"""A sweep on a real Slurm of one node, with daemons, keys and ports of its own."""
import csv
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import time
import unittest

from soarbox_command import Run
from test_missions import RULES, SWEEP, WORLD

DAEMONS = ("slurmctld", "slurmd", "munged", "sbatch", "squeue", "scancel")


def missing():
    paths = os.environ["PATH"] + ":/usr/sbin:/sbin"
    absent = [name for name in DAEMONS if not shutil.which(name, path=paths)]
    if absent:
        return "Slurm is not installed here: " + ", ".join(absent)
    return "Slurm's daemons want to be started by root" if os.geteuid() != 0 else ""


def free_port():
    with socket.socket() as there:
        there.bind(("127.0.0.1", 0))
        return there.getsockname()[1]


@unittest.skipIf(missing(), missing())
class OnSlurm(unittest.TestCase):
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
        conf.write_text(f"""
ClusterName=here
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
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
SlurmdSpoolDir={self.folder}/spool
SlurmctldPidFile={self.folder}/slurmctld.pid
SlurmdPidFile={self.folder}/slurmd.pid
SlurmctldLogFile={self.folder}/slurmctld.log
SlurmdLogFile={self.folder}/slurmd.log
SchedulerParameters=sched_interval=1
MinJobAge=5
NodeName={host} NodeAddr=127.0.0.1 CPUs={processors} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
""", encoding="utf-8")
        (self.folder / "state").mkdir()
        (self.folder / "spool").mkdir()
        os.environ["SLURM_CONF"] = str(conf)
        self.addCleanup(os.environ.pop, "SLURM_CONF")
        self.daemons = []
        self.addCleanup(self.stop)
        self.start("munged", "--foreground", "--force", "--key-file", key, "--socket", sock, "--log-file", self.folder / "munge.log",
                   "--pid-file", self.folder / "munge.pid", "--seed-file", self.folder / "munge.seed")
        self.wait(sock.exists)
        self.start("slurmctld", "-D", "-f", conf)
        self.start("slurmd", "-D", "-f", conf, "-N", host)
        self.wait(lambda: "idle" in subprocess.run(["sinfo", "-h", "-o", "%T"], capture_output=True, text=True, check=False).stdout)

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

    def test_a_job_array_with_a_task_killed_comes_to_the_local_table(self):
        (self.folder / "scenario.toml").write_text(WORLD, encoding="utf-8")
        (self.folder / "scout.soar").write_text(RULES, encoding="utf-8")
        spec = self.folder / "sweep.toml"
        spec.write_text(SWEEP.replace("1..6", "1..100"), encoding="utf-8")
        there = self.folder / "there"

        def kill_one():
            # A task in the middle of its work: what it has made stays, the rest is given out again.
            end = time.monotonic() + 60
            while time.monotonic() < end:
                for entry in pathlib.Path("/proc").glob("[0-9]*"):
                    try:
                        words = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
                    except OSError:
                        continue
                    if str(there) in words and "--task" in words and any((there / "parts").glob("*.rows")):
                        os.kill(int(entry.name), signal.SIGKILL)
                        return
                time.sleep(0.1)

        killer = threading.Thread(target=kill_one)
        killer.start()
        run = Run("sweep", spec, "--folder", there, "--on", "slurm", "--tasks", "3")
        killer.join()
        self.assertEqual(run.code, 0, run.out + run.err)
        self.assertEqual(Run("sweep", spec, "--folder", self.folder / "here").code, 0)
        rows = self.rows(there)
        self.assertEqual(len(rows), 200)
        self.assertEqual(rows, self.rows(self.folder / "here"))


if __name__ == "__main__":
    unittest.main()
