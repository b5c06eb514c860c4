// SPDX-License-Identifier: BSD-2-Clause
// Two trees beside the editor: the operators of the program with their rules, and its datamap.
'use strict';

const vscode = require('vscode');

/// The nodes of an operator: its rules, then the operators that are proposed in its substates. `above`: the operators on
/// the way to it, none of which is shown again.
function operatorNode(one, all, above) {
  const way = new Set(above).add(one.name);
  return {
    label: one.name || 'Rules without an operator',
    icon: one.name ? 'symbol-event' : 'list-unordered',
    children: [
      ...one.rules.map((rule) => ({label: rule.name, detail: rule.role, icon: 'symbol-method', location: rule.location, children: []})),
      ...all.filter((other) => other.parents.includes(one.name) && !way.has(other.name)).map((other) => operatorNode(other, all, way)),
    ],
  };
}

/// The operators that no other one contains are on top. If operators contain each other, all are.
function operatorNodes(all) {
  const top = all.filter((one) => one.parents.length === 0);
  return (top.length ? top : all).map((one) => operatorNode(one, all, []));
}

function datamapNodes(all) {
  return all.map((one) => ({
    label: '^' + one.name, detail: one.detail, icon: one.children.length ? 'symbol-object' : 'symbol-field', children: datamapNodes(one.children),
  }));
}

class Tree {
  constructor(ask, request, nodes) {
    this.ask = ask;
    this.request = request;
    this.nodes = nodes;
    this.changed = new vscode.EventEmitter();
    this.onDidChangeTreeData = this.changed.event;
  }

  refresh() {
    this.changed.fire(undefined);
  }

  async getChildren(node) {
    if (node) return node.children;
    const editor = vscode.window.activeTextEditor;
    if (editor && editor.document.languageId === 'soar') this.uri = editor.document.uri.toString();
    return this.uri ? this.nodes(await this.ask(this.request, {textDocument: {uri: this.uri}}) || []) : [];
  }

  getTreeItem(node) {
    const {None, Collapsed} = vscode.TreeItemCollapsibleState;
    const item = new vscode.TreeItem(node.label, node.children.length ? Collapsed : None);
    item.description = node.detail;
    item.iconPath = new vscode.ThemeIcon(node.icon);
    if (node.location) {
      const {start} = node.location.range;
      const at = new vscode.Position(start.line, start.character);
      item.command = {command: 'vscode.open', title: 'Open', arguments: [vscode.Uri.parse(node.location.uri), {selection: new vscode.Range(at, at)}]};
    }
    return item;
  }
}

/// `ask` sends a request to the language server; it answers undefined if there is none.
function register(context, ask) {
  const trees = [new Tree(ask, 'soarbox/operators', operatorNodes), new Tree(ask, 'soarbox/datamap', datamapNodes)];
  const refresh = () => trees.forEach((tree) => tree.refresh());
  context.subscriptions.push(
      vscode.window.registerTreeDataProvider('soarbox.operators', trees[0]),
      vscode.window.registerTreeDataProvider('soarbox.datamap', trees[1]),
      vscode.window.onDidChangeActiveTextEditor(refresh),
      vscode.workspace.onDidSaveTextDocument((document) => document.languageId === 'soar' && refresh()));
  return refresh;
}

module.exports = {register, operatorNodes, datamapNodes};
