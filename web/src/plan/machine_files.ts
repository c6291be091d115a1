// Which files are a machine's.

export const isToml = ({ name }: { readonly name: string }): boolean => /\.toml$/i.test(name);

// Whether a machine file of this text names it, as it does its tool table and its height map: as a string, with a folder or without.
export function names(machine: string, name: string): boolean {
  return [...machine.matchAll(/"([^"\n]*)"|'([^'\n]*)'/g)].some(([, one, other]) => (one ?? other ?? "").split("/").at(-1) === name);
}
