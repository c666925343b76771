// SPDX-License-Identifier: MIT
// What eslint looks for in the scripts of the page and of the npm package and in their tests: mistakes, not style. Run in samples: scripts_test.sh.
import js from "@eslint/js";
import globals from "globals";

const rules = {
  ...js.configs.recommended.rules,
  "no-unused-vars": ["error", { argsIgnorePattern: "^_", varsIgnorePattern: "^_", ignoreRestSiblings: true, caughtErrors: "none" }],
  eqeqeq: ["error", "always", { null: "ignore" }], // == null: neither of the two
  "no-var": "error",
  "prefer-const": ["error", { destructuring: "all" }],
  "no-shadow": "error",
  "no-implicit-globals": "error",
  "no-promise-executor-return": "off",
  "require-await": "error",
  "no-self-compare": "error",
  "no-unreachable-loop": "error",
  "no-useless-return": "error",
  "no-template-curly-in-string": "error",
  "array-callback-return": "error",
};

export default [
  { ignores: ["**/node_modules/**", "**/dist*/**"] },
  { files: ["web/src/**/*.js", "npm/src/**/*.js"], languageOptions: { globals: { ...globals.browser, ...globals.serviceworker } }, rules },
  { files: ["crowd/**/*.js"], languageOptions: { globals: globals.browser }, rules },
  { files: ["crowd/test/*.mjs"], languageOptions: { globals: { ...globals.node, ...globals.browser } }, rules: { ...rules, "no-shadow": "off" } },
  { files: ["npm/src/host_node.js"], languageOptions: { globals: globals.node }, rules },
  { files: ["web/{samples,test,wasm}/**/*.mjs", "npm/test/**/*.mjs"], languageOptions: { globals: { ...globals.node, ...globals.browser, sinewPage: "readonly" } }, rules: { ...rules, "no-shadow": "off" } },
];
