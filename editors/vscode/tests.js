// SPDX-License-Identifier: BSD-2-Clause
// Missions in the test explorer: `soarbox test --json` reports the results.
'use strict';

const childProcess = require('child_process');
const vscode = require('vscode');

/// The run of one mission, as a promise of the lines that it printed. `program`: returns the command with these arguments.
function runMission(program, file, token) {
  return new Promise((resolve) => {
    const {command, args, env} = program('test', file, '--json', '--no-keep');
    const child = childProcess.spawn(command, args, {env: {...process.env, ...env}});
    let out = '', err = '';
    child.stdout.on('data', (data) => out += data);
    child.stderr.on('data', (data) => err += data);
    token.onCancellationRequested(() => child.kill());
    child.on('error', (problem) => resolve({code: -1, out, err: String(problem)}));
    child.on('close', (code) => resolve({code, out, err}));
  });
}

function register(context, program) {
  const controller = vscode.tests.createTestController('soarbox', 'Soarbox missions');
  context.subscriptions.push(controller);
  const pattern = '**/*mission*.toml';
  const add = (uri) => {
    const name = vscode.workspace.asRelativePath(uri);
    controller.items.add(controller.createTestItem(uri.toString(), name, uri));
  };
  const watcher = vscode.workspace.createFileSystemWatcher(pattern);
  watcher.onDidCreate(add);
  watcher.onDidDelete((uri) => controller.items.delete(uri.toString()));
  context.subscriptions.push(watcher);
  const find = async () => (await vscode.workspace.findFiles(pattern)).forEach(add);
  controller.resolveHandler = (item) => item ? undefined : find();
  controller.createRunProfile('Run', vscode.TestRunProfileKind.Run, async (request, token) => {
    const run = controller.createTestRun(request);
    const items = request.include || [];
    if (!request.include) controller.items.forEach((item) => items.push(item));
    for (const item of items) {
      if (token.isCancellationRequested) break;
      run.started(item);
      const begun = Date.now();
      const done = await runMission(program, item.uri.fsPath, token);
      run.appendOutput((done.out + done.err).replace(/\r?\n/g, '\r\n'), undefined, item);
      if (done.code === 0) {
        run.passed(item, Date.now() - begun);
      } else {
        run.failed(item, new vscode.TestMessage(done.err || done.out), Date.now() - begun);
      }
    }
    run.end();
  }, true);
  find();
}

module.exports = {register};
