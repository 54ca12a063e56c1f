// Khronos' glTF validator on files: a line for each error and warning, exit code 1 if there is any, 2 where the
// npm package gltf-validator is not installed (npm install gltf-validator, and NODE_PATH to its node_modules).
const fs = require('fs');

let validator;
try {
  validator = require('gltf-validator');
} catch (missing) {
  process.exit(2);
}

(async () => {
  let found = 0;
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
    for (const m of report.issues.messages) {
      if (m.severity > 1) continue; // 0: error, 1: warning; then information and hints
      console.log(`${file}: ${m.pointer}: ${m.code}: ${m.message}`);
      found += 1;
    }
  }
  process.exit(found > 0 ? 1 : 0);
})();
