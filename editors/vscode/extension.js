// SPDX-License-Identifier: BSD-2-Clause
// The extension only translates: everything about Soar comes from the soarbox command.
'use strict';

const vscode = require('vscode');
const {LanguageClient} = require('vscode-languageclient/node');
const {findProgram} = require('./program');
const tests = require('./tests');
const trees = require('./trees');

let client;

/// The command to start, with some arguments, as {command, args, env}.
function program(...words) {
  const folders = [__dirname, ...(vscode.workspace.workspaceFolders || []).map((folder) => folder.uri.fsPath)];
  const found = findProgram(vscode.workspace.getConfiguration('soarbox').get('command'), process.env.PATH, folders);
  return {...found, args: [...found.args, ...words]};
}

async function startClient() {
  const {command, args, env} = program('lsp');
  client = new LanguageClient('soarbox', 'Soarbox', {command, args, options: {env: {...process.env, ...env}}}, {
    documentSelector: [{scheme: 'file', language: 'soar'}],
    synchronize: {fileEvents: vscode.workspace.createFileSystemWatcher('**/*.{soar,vsa,json,toml,soarrec}')},
    middleware: {
      // The lens over a rule: why it does, or does not, match at the end of the recorded run.
      async executeCommand(name, given, next) {
        const answer = await next(name, given);
        if (name === 'soarbox.why' && answer && answer.text) {
          const document = await vscode.workspace.openTextDocument({content: answer.text});
          await vscode.window.showTextDocument(document, {preview: true, viewColumn: vscode.ViewColumn.Beside});
        }
        return answer;
      },
    },
  });
  try {
    await client.start();
  } catch (problem) {
    client = undefined;
    vscode.window.showErrorMessage(`Soarbox: ${command} ${args.join(' ')} does not start: set soarbox.command to the command's path, or install Soarbox's npm package (docs/npm.md) in the folder of your rules`);
  }
}

function task(action, file) {
  const {command, args, env, isPackage} = program(action, ...(file ? [file] : []));
  // The package has no window.
  if (isPackage && action === 'run') args.push('--headless');
  const made = new vscode.Task({type: 'soarbox', action, file}, vscode.TaskScope.Workspace, file ? `${action} ${file}` : action, 'soarbox',
      new vscode.ProcessExecution(command, args, {env}), '$soarbox');
  if (action === 'test') made.group = vscode.TaskGroup.Test;
  return made;
}

function currentFile() {
  const editor = vscode.window.activeTextEditor;
  return editor && editor.document.uri.scheme === 'file' ? editor.document.uri.fsPath : undefined;
}

async function activate(context) {
  const register = (name, action) => context.subscriptions.push(vscode.commands.registerCommand(name, action));
  const start = async (action) => {
    const file = currentFile();
    if (!file) return vscode.window.showInformationMessage('Soarbox: open a file of rules first');
    await vscode.window.activeTextEditor.document.save();
    return vscode.tasks.executeTask(task(action, file));
  };
  register('soarbox.run', () => start('run'));
  register('soarbox.check', () => start('check'));
  register('soarbox.restart', async () => {
    if (client) await client.stop();
    await startClient();
  });
  context.subscriptions.push(vscode.tasks.registerTaskProvider('soarbox', {
    provideTasks: () => [task('check', '.'), task('test'), task('format', '.')],
    resolveTask: (given) => task(given.definition.action, given.definition.file),
  }));
  context.subscriptions.push(vscode.debug.registerDebugAdapterDescriptorFactory('soarbox', {
    createDebugAdapterDescriptor: () => {
      const {command, args, env} = program('dap');
      return new vscode.DebugAdapterExecutable(command, args, {env});
    },
  }));
  tests.register(context, program);
  const refresh = trees.register(context, (request, given) => client && client.sendRequest(request, given).catch(() => undefined));
  await startClient();
  refresh();
}

async function deactivate() {
  if (client) await client.stop();
}

module.exports = {activate, deactivate};
