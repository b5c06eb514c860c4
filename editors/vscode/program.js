// SPDX-License-Identifier: BSD-2-Clause
// Finds the soarbox command: the native program, or the npm package `soarbox`, which the Node.js of the editor runs.
'use strict';

const fs = require('fs');
const path = require('path');

function isFile(file) {
  try {
    return fs.statSync(file).isFile();
  } catch (problem) {
    return false;
  }
}

/// The file of a program in one of the folders of a search path, or undefined. `endings`: of programs on this system.
function onPath(name, searched, endings) {
  const folders = (searched || '').split(path.delimiter).filter(Boolean);
  return folders.flatMap((folder) => endings.map((ending) => path.join(folder, name + ending))).find(isFile);
}

/// The program to start as {command, args, env, isPackage}. `env` contains only the variables to add.
///   configured  the setting soarbox.command; empty: search
///   searched    the search path
///   folders     folders that may have the npm package in node_modules: the extension's, those of the workspace
/// Without a native program and a package, the result is the command by its name. The system's error names it.
function findProgram(configured, searched, folders, platform = process.platform) {
  const native = {args: [], env: {}, isPackage: false};
  if (configured && configured !== 'soarbox') return {...native, command: configured};
  const found = onPath('soarbox', searched, platform === 'win32' ? ['.exe'] : ['']);
  if (found) return {...native, command: found};
  const script = folders.map((folder) => path.join(folder, 'node_modules', 'soarbox', 'soarbox.js')).find(isFile);
  // The editor's own program behaves as Node.js with this variable.
  if (script) return {command: process.execPath, args: [script], env: {ELECTRON_RUN_AS_NODE: '1'}, isPackage: true};
  return {...native, command: 'soarbox'};
}

module.exports = {findProgram};
