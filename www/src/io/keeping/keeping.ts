import { readAll, remove, write, type KeptText } from "./database.ts";
import { byAge, generationOf, sessionOf, unseal } from "./sealed.ts";
import { keepAtOnce, keysOf, localStore, markKept } from "./store.ts";

/**
 * What is kept, wherever: the database has all of it, and the local store what was written when there was no time, or
 * no database.
 */

function inLocalStore(): KeptText[] {
  const storage = localStore();
  try {
    return storage === null ? [] : keysOf(storage).map((key) => ({ key, text: storage.getItem(key) ?? "" }));
  } catch {
    return [];
  }
}

function forgetLocally(keys: readonly string[]): void {
  const storage = localStore();
  try {
    for (const key of keys) storage?.removeItem(key);
  } catch {
    // What cannot be reached is not read either.
  }
}

/** A page that is being left may have kept a newer one in the same place, while this one was on its way. */
function isOutdone({ key, text }: KeptText): boolean {
  return inLocalStore().some((there) => there.key === key && generationOf(there.text) > generationOf(text));
}

/** Everything that is kept. What lies in the local store moves into the database. */
export async function allKept(): Promise<KeptText[]> {
  const local = inLocalStore();
  const known = await readAll().catch((): KeptText[] => []);
  const wholeOf = (kept: KeptText | undefined): number => (kept === undefined ? -1 : (unseal(kept)?.generation ?? -1));
  const newer = local.filter((kept) => wholeOf(kept) > wholeOf(known.find(({ key }) => key === kept.key)));
  for (const kept of local) {
    const moved = !newer.includes(kept) || (await write(kept).catch(() => false));
    if (moved) forgetLocally([kept.key]);
  }
  if (known.length + local.length > 0) markKept(localStore());
  return [...known.filter(({ key }) => !newer.some((kept) => kept.key === key)), ...newer];
}

/** Sessions that stay; the oldest give way. */
const mostSessions = 4;

/** Whether the database took it, or said that it is full. */
async function written(kept: KeptText): Promise<boolean | "full"> {
  try {
    if (!(await write(kept))) return false;
  } catch (error) {
    return (error as { name?: unknown } | null)?.name === "QuotaExceededError" ? "full" : false;
  }
  if (!isOutdone(kept)) forgetLocally([kept.key]);
  markKept(localStore());
  return true;
}

/**
 * Keeps a text: in the database, else in the local store. Says whether it is kept. Only for want of room other sessions
 * give way.
 */
export async function keep(kept: KeptText): Promise<boolean> {
  let done = await written(kept);
  if (done === "full") {
    await makeRoom(sessionOf(kept.key), 1);
    done = await written(kept);
  }
  return done === true || isOutdone(kept) || keepAtOnce(kept);
}

/** Leaves so many sessions, this one among them. */
export async function makeRoom(session: string, most = mostSessions): Promise<void> {
  const all = [...inLocalStore(), ...(await readAll().catch(() => []))];
  const ages = all.flatMap((kept) => unseal(kept) ?? []).sort(byAge);
  const others = [...new Set([...ages.map((sealed) => sealed.session), ...all.map(({ key }) => sessionOf(key))])].filter((other) => other !== session);
  await forgetSessions(others.slice(most - 1));
}

async function forgetSessions(sessions: readonly string[]): Promise<void> {
  const of = ({ key }: KeptText): boolean => sessions.includes(sessionOf(key));
  forgetLocally(inLocalStore().filter(of).map(({ key }) => key));
  const stored = await readAll().catch(() => []);
  await remove(stored.filter(of).map(({ key }) => key)).catch(() => undefined);
}
