# SPDX-License-Identifier: BSD-2-Clause
"""Neovim without a screen, configured as in docs/editors.md: it shows problems, completes and renames."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from editor_client import COMMAND
from test_lsp import MAIN, MOVES

DOCUMENT = pathlib.Path(__file__).resolve().parent.parent.parent / "docs" / "editors.md"

SCRIPT = """
local found = {}
local function wait_for(what, holds)
  if not vim.wait(30000, holds, 20) then error('no ' .. what) end
end
vim.cmd('edit main.soar')
wait_for('client', function() return #vim.lsp.get_active_clients() > 0 and vim.lsp.get_active_clients()[1].initialized end)
-- An attribute that nothing writes.
wait_for('diagnostics', function() return #vim.diagnostic.get(0) > 0 end)
for _, one in ipairs(vim.diagnostic.get(0)) do
  table.insert(found, {line = one.lnum, message = one.message})
end
local function ask(method, params)
  local answers = vim.lsp.buf_request_sync(0, method, params, 30000)
  for _, answer in pairs(answers) do
    if answer.error then error(answer.error.message) end
    return answer.result
  end
end
-- Behind ^ of (<a> ^relaton enemy ...).
vim.fn.search('relaton')
local items = vim.lsp.util.text_document_completion_list_to_complete_items(ask('textDocument/completion', vim.lsp.util.make_position_params()), '')
local words = {}
for _, item in ipairs(items) do table.insert(words, item.word) end
vim.fn.search('foe')
vim.lsp.buf.rename('prey')
wait_for('renaming', function() return vim.fn.search('\\\\^prey', 'nw') > 0 end)
vim.cmd('silent wall')
vim.fn.writefile({vim.fn.json_encode({problems = found, words = words, filetype = vim.bo.filetype})}, 'result.json')
vim.cmd('qall!')
"""


@unittest.skipUnless(shutil.which("nvim"), "Neovim is not installed")
class Neovim(unittest.TestCase):
    def test_it_reads_problems_completes_and_renames(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name).resolve()
            # Words in scripts next to the rules would count as percepts.
            own = folder / "editor"
            own.mkdir()
            (folder / "main.soar").write_text(MAIN.replace("^relation", "^relaton"))
            (folder / "moves.soar").write_text(MOVES)
            (own / "soarbox").symlink_to(COMMAND)
            lines = re.search(r"```lua\n(.*?)```", DOCUMENT.read_text(), re.DOTALL).group(1)
            self.assertLessEqual(len(lines.splitlines()), 10)
            (own / "init.lua").write_text(lines)
            (own / "script.lua").write_text("local ok, problem = pcall(function()" + SCRIPT +
                                               "end) if not ok then vim.fn.writefile({tostring(problem)}, 'problem.txt') vim.cmd('cquit!') end")
            environment = dict(os.environ, PATH=f"{own}:{os.environ['PATH']}", HOME=name, XDG_STATE_HOME=name, NVIM_LOG_FILE="/dev/null")
            run = subprocess.run(["nvim", "--headless", "-u", "editor/init.lua", "-c", "luafile editor/script.lua"], cwd=folder, env=environment,
                                 capture_output=True, text=True, timeout=120, check=False)
            problem = folder / "problem.txt"
            self.assertEqual(0, run.returncode, run.stderr + (problem.read_text() if problem.exists() else ""))
            result = json.loads((folder / "result.json").read_text())
            self.assertEqual("soar", result["filetype"])
            self.assertIn("relaton", json.dumps(result["problems"]))
            self.assertTrue({"relation", "range", "bearing"} <= set(result["words"]), result["words"])
            self.assertIn("^prey", (folder / "main.soar").read_text())
            self.assertEqual(MOVES.replace("^foe", "^prey"), (folder / "moves.soar").read_text())
