"use strict";

const { workspace } = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

function activate() {
  const command = workspace.getConfiguration("bringup-lint").get("path");
  const server = { command, args: ["server", "--stdio"] };
  client = new LanguageClient("bringup-lint", "bringup-lint", server, { documentSelector: [{ scheme: "file" }] });
  return client.start();
}

function deactivate() {
  return client ? client.stop() : undefined;
}

module.exports = { activate, deactivate };
