// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// node run_wasi.mjs PROGRAM.wasm ARGUMENTS…: a WebAssembly program of the system interface WASI.

import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

const args = process.argv.slice(2);
const wasi = new WASI({ version: 'preview1', args, env: {}, returnOnExit: true });
const module = await WebAssembly.compile(await readFile(args[0]));
const instance = await WebAssembly.instantiate(module, wasi.getImportObject());
process.exitCode = wasi.start(instance);
