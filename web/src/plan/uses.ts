// How much of each limit a run uses.
import type { Plan, Quantity } from "./plan.ts";

interface Use {
  readonly track: string;
  readonly quantity: Quantity;
  readonly peak: number;
  readonly limit: number | null;
  readonly share: number; // 0 without a limit
}

// The largest figures as --json has them, with their limits.
export function usesOf(plan: Plan): Use[] {
  const max = plan.header.report.max;
  if (!max) return [];
  const keys: readonly (readonly [Quantity, string])[] = [
    ["v", "v_"],
    ["a", "a_"],
    ["j", "j_"],
  ];
  return plan.tracks.flatMap((track) => {
    const figures = track === "path" ? max.path : max.axes[track];
    return keys.flatMap(([quantity, key]) => {
      const found = Object.entries(figures ?? {}).find(([name]) => name.startsWith(key));
      if (!found) return [];
      const limit = plan.limitOf(track, quantity);
      return [{ track, quantity, peak: found[1], limit, share: limit ? found[1] / limit : 0 }];
    });
  });
}
