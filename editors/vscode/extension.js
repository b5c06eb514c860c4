// SPDX-License-Identifier: BSD-2-Clause
// The extension only translates: everything about Soar comes from the soarbox command.
'use strict';

const vscode = require('vscode');
const {LanguageClient} = require('vscode-languageclient/node');
const tests = require('./tests');
const trees = require('./trees');

let client;

function command() {
  return vscode.workspace.getConfiguration('soarbox').get('command') || 'soarbox';
}

async function startClient() {
  client = new LanguageClient('soarbox', 'Soarbox', {command: command(), args: ['lsp']}, {
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
    vscode.window.showErrorMessage(`Soarbox: ${command()} lsp does not start: set soarbox.command to the command's path`);
  }
}

function task(action, file) {
  const made = new vscode.Task({type: 'soarbox', action, file}, vscode.TaskScope.Workspace, file ? `${action} ${file}` : action, 'soarbox',
      new vscode.ProcessExecution(command(), file ? [action, file] : [action]), '$soarbox');
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
    createDebugAdapterDescriptor: () => new vscode.DebugAdapterExecutable(command(), ['dap']),
  }));
  tests.register(context, command);
  const refresh = trees.register(context, (request, given) => client && client.sendRequest(request, given).catch(() => undefined));
  await startClient();
  refresh();
}

async function deactivate() {
  if (client) await client.stop();
}

module.exports = {activate, deactivate};
