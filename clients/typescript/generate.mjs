// Makes src/generated/ in a clone (python3 -m codegen); this folder of a release has it.
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../', import.meta.url));
if (existsSync(`${root}codegen`)) execFileSync('python3', ['-m', 'codegen'], { cwd: root, stdio: 'inherit' });
