import type { createClient } from "../api/client.js";
import type { Preset } from "../api/answers.js";
import type { Picture } from "../pictures/panel-picture.js";
import type { Accuracy } from "../state/accuracy.js";
import type { CollisionWish, LoadedCollision, Source } from "../state/loading/collision-load.js";
import type { Collision } from "../state/parameters.js";
import type { Change } from "../state/store.js";
import type { PageState } from "../state/address/options.js";

/** What the page gives to each of its scenes. */
export interface Page {
  client: ReturnType<typeof createClient>;
  /** Who is asked for what the kernel in the page may answer. */
  source: Source;
  present(): PageState;
  set(patch: Partial<PageState>, change?: Partial<Change>): void;
  setCollision(patch: Partial<Collision>, change?: Partial<Change>): void;
  setAccuracy(patch: Partial<Accuracy>, change?: Partial<Change>): void;
  /** Shows ε_t as far as it is known before the server has answered, or that it is not. */
  preview(reading: { epsilon_t: number; switches: number } | null): void;
  /** Tells a refusal to the reader, with its language where that is not the one of the page. */
  say(reason: string, language?: string): void;
  /** What is to be done about an error of the client, a refusal as is said. */
  explainBy(refuse: (reason: string, language: string) => void): (error: unknown) => void;
  /** The same with every refusal told to the reader. */
  explain(error: unknown): void;
  reportLost(reason: string): void;
}

/** A part of the page that is shown for some of its states. */
export interface Scene {
  /** Shows what is known without asking anyone; it is called at every change. */
  show(state: PageState, previous: PageState | null, change: Change): void;
  /** Asks for what a state shows besides the collision itself; it is called while the server answers. */
  follow(state: PageState, previous: PageState | null, change: Change): void;
  /** Shows the answer about a collision. */
  settle?(answer: LoadedCollision, wish: CollisionWish, isPresent: boolean): void;
  /** Whether the collision of this state is still to come from what the scene asks for. */
  decides?(state: PageState, previous: PageState): boolean;
  /** Takes the presets, once they are here. */
  offer?(presets: Preset[]): void;
  /** Takes nothing for answered, as after the server was away. */
  forget(): void;
  /** What the menus of its panels need to know, by the names of the panels. */
  pictures: Record<string, Picture>;
}
