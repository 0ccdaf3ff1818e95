// What a host of the course starts from: the workflow that checks and publishes it, and the container in which a
// browser's editor opens it.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const require = createRequire(join(resolve(process.env.BYHAND_MODULES), 'package.json'));
const { validateWorkflow } = require('@action-validator/core');
const root = join(dirname(fileURLToPath(import.meta.url)), '../../..');
const workflows = join(root, '.github/workflows');

for (const name of readdirSync(workflows))
  test(`${name} follows the schema of workflows, and runs commands that are there`, () => {
    const text = readFileSync(join(workflows, name), 'utf8');
    assert.deepEqual(validateWorkflow(text).errors, []);
    assert.notDeepEqual(validateWorkflow(text.replace('runs-on:', 'runs_on:')).errors, [], 'the schema is looked at');
    const commands = [...text.matchAll(/run: (\.\S+)/g)].map(([, command]) => command);
    assert.deepEqual(commands, ['.ci/run', './lessons/run']);
    for (const command of commands) assert.ok(statSync(join(root, command)).mode & 0o100, command);
  });

// The properties of the container's reference that we use, and what they hold.
const properties = {
  name: /./, image: /^[a-z0-9./-]+:debian-12$/, remoteUser: /^root$/, postCreateCommand: /^apt-get update$/,
  postAttachCommand: /^\.\/lessons\/run$/, hostRequirements: { cpus: /^\d+$/, memory: /^\d+([tgmk]b)?$/ },
};

test('the container is Debian 12 and opens the course', () => {
  const hold = (values, allowed) => {
    for (const [key, value] of Object.entries(values))
      allowed[key] instanceof RegExp ? assert.match(String(value), allowed[key]) : hold(value, allowed[key] ?? assert.fail(`${key} is no property of a container`));
  };
  const container = JSON.parse(readFileSync(join(root, '.devcontainer/devcontainer.json'), 'utf8'));
  hold(container, properties);
  assert.ok(existsSync(join(root, container.postAttachCommand)));
});
