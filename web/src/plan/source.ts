// Where plans come from. Embedded in the page here; computed in the browser, or sent by a server, it is this interface.
import type { Plan } from "./plan.ts";

export interface PlanSource {
  // All plans that stand side by side.
  plans(): Promise<Plan[]>;
}
