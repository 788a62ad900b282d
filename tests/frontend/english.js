// Loaded before every test: what the page says is said in English, unless a test learns another language.
import { learn } from "../../frontend/format/words.js";
import { wordsOf } from "./locales.js";

learn(wordsOf("en"));
