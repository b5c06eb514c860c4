# SPDX-License-Identifier: BSD-2-Clause
"""The check of layers accepts includes that follow the order, and finds those that do not."""
import pathlib
import tempfile
import unittest

import check_layers


class TheCheckOfLayers(unittest.TestCase):
    def found(self, file, *includes):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / file
            path.parent.mkdir(parents=True)
            path.write_text("".join(f'#include "{include}"\n' for include in includes), encoding="utf-8")
            return list(check_layers.offences(pathlib.Path(folder)))

    def assert_passes(self, file, *includes):
        self.assertEqual(self.found(file, *includes), [])

    def assert_finds(self, file, include):
        self.assertEqual(len(self.found(file, "kernel/base/ids.h", include)), 1)

    def test_modules(self):
        self.assert_passes("cli/tokens.cpp", "kernel/agent.h", "cli/tokens.h")
        self.assert_finds("kernel/base/ids.cpp", "cli/tokens.h")

    def test_folders_of_the_kernel(self):
        self.assert_passes("kernel/memory/links.cpp", "kernel/base/ids.h", "kernel/match/rete.h", "kernel/memory/links.h")
        self.assertEqual(len(self.found("kernel/memory/links.cpp", "kernel/decide/agent_core.h")), 2)
        self.assert_finds("kernel/io/input_link.cpp", "kernel/decide/firing.h")
        self.assert_finds("kernel/match/rete.h", "kernel/memory/working_memory.h")
        self.assert_finds("kernel/decide/firing.cpp", "kernel/learn/chunker.h")

    def test_the_face_is_above_the_folders(self):
        self.assert_passes("kernel/agent.cpp", "kernel/longterm/long_term.h")
        self.assert_finds("kernel/memory/links.cpp", "kernel/agent.h")
        self.assert_passes("kernel/decide/observers.h", "kernel/observer.h")

    def test_what_an_agent_consists_of_knows_all_parts(self):
        self.assert_passes("kernel/decide/agent_core.h", "kernel/learn/chunker.h")

    def test_only_a_list_of_files_may_use_the_core(self):
        self.assert_passes("kernel/decide/firing.cpp", "kernel/decide/agent_core.h")
        self.assert_finds("kernel/learn/chunker.cpp", "kernel/decide/agent_core.h")
        self.assert_finds("kernel/longterm/installer.cpp", "kernel/decide/agent_core.h")
        self.assert_finds("kernel/decide/goal_stack.cpp", "kernel/decide/agent_core.h")
        self.assert_finds("kernel/decide/firing.h", "kernel/decide/agent_core.h")
        self.assert_finds("kernel/learn/chunking_test.cpp", "kernel/decide/agent_core.h")

    def test_the_list_of_those_who_use_the_core_never_grows(self):
        self.assertLessEqual(len(check_layers.USERS_OF_CORE), 16)
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for file in check_layers.USERS_OF_CORE:
                (root / file).parent.mkdir(parents=True, exist_ok=True)
                (root / file).write_text('#include "kernel/decide/agent_core.h"\n', encoding="utf-8")
            self.assertEqual(list(check_layers.strangers_to_core(root)), [])
            (root / "kernel/decide/firing.cpp").write_text('#include "kernel/decide/firing.h"\n', encoding="utf-8")
            self.assertEqual(len(list(check_layers.strangers_to_core(root))), 1)

    def test_tests_may_use_the_face(self):
        self.assert_passes("kernel/match/rete_test.cpp", "kernel/agent.h")
