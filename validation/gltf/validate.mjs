// Runs Khronos' glTF validator on the files named: `node validate.mjs FILE.glb...`. Exit 1 on any error or warning.
import { readFile } from "node:fs/promises";
import { basename } from "node:path";
import validator from "gltf-validator";

const files = process.argv.slice(2);
if (files.length === 0) {
  console.error("usage: node validate.mjs FILE.glb...");
  process.exit(2);
}
let found = 0;
for (const file of files) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(file)), { uri: basename(file) });
  const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
  found += numErrors + numWarnings;
  const { totalVertexCount, totalTriangleCount, animationCount, hasMorphTargets } = report.info;
  console.log(
    `${basename(file)}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints; ` +
      `${totalVertexCount} vertices, ${totalTriangleCount} triangles, ${animationCount} animations, ` +
      `morph targets ${hasMorphTargets ? "yes" : "no"} (validator ${validator.version()})`,
  );
  for (const { code, message, pointer } of messages) console.log(`  ${code} ${pointer ?? ""}: ${message}`);
}
process.exit(found > 0 ? 1 : 0);
