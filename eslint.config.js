import js from "@eslint/js";
import { defineConfig, globalIgnores } from "eslint/config";
import globals from "globals";

export default defineConfig([
  globalIgnores([".venv/", "build/"]),
  js.configs.recommended,
  {
    rules: {
      "consistent-return": "error",
      curly: "error",
      eqeqeq: "error",
      "no-console": "error",
      "no-implicit-coercion": "error",
      "no-shadow": "error",
      "no-var": "error",
      "object-shorthand": "error",
      "prefer-const": "error",
      "prefer-template": "error",
    },
  },
  {
    files: ["frontend/**/*.js"],
    languageOptions: { globals: { ...globals.browser, Plotly: "readonly" } },
  },
  {
    // A figure is data to data: it runs under node --test, so no global of the browser is there.
    files: ["frontend/figures/**/*.js", "frontend/format/**/*.js"],
    languageOptions: {
      globals: Object.fromEntries(
        ["document", "window", "localStorage", "location", "fetch", "Plotly"].map((name) => [
          name,
          "off",
        ]),
      ),
    },
  },
  {
    files: ["tests/frontend/**/*.js", "*.config.js"],
    languageOptions: { globals: globals.nodeBuiltin },
  },
  {
    // A function that a test has evaluated on the page.
    files: ["tests/browser/*.js"],
    languageOptions: { globals: globals.browser },
    rules: { "no-unused-expressions": "off" },
  },
]);
