// The system's Chromium: found, installed from apt when missing, and started for tests.

import { accessSync, constants, existsSync } from "node:fs";
import { delimiter, join } from "node:path";

import { StepError, run } from "./steps.mjs";

/** Chromium without windows first: it opens a page in a quarter of the processor's time that one with windows takes. */
const NAMES = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome-stable", "google-chrome", "chrome"];
const ELSEWHERE = [
  "/snap/bin/chromium",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
];

/** Flags for a quiet start without calls to the network; the page's own rendering stays as it is for a person. */
const FLAGS = [
  "--disable-gpu",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--disable-dev-shm-usage",
];

function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/** The path of a Chromium or Chrome: `$CHROMIUM`, else the system's; undefined when there is none. */
export function findChromium() {
  const wanted = process.env.CHROMIUM;
  if (wanted) {
    if (!existsSync(wanted)) throw new StepError(`CHROMIUM names ${wanted}, which is not there`);
    return wanted;
  }
  const folders = (process.env.PATH ?? "").split(delimiter);
  const candidates = folders.flatMap((folder) => NAMES.map((name) => join(folder, name)));
  return [...candidates, ...ELSEWHERE].find(isProgram);
}

/** What apt is asked for, the first that it has; not every system has Chromium without windows apart. */
const PACKAGES = ["chromium-headless-shell", "chromium"];

/** Finds Chromium or installs it with apt, as root or with a sudo that asks for no password. */
export async function ensureChromium() {
  const found = findChromium();
  if (found) return found;
  const sudo = process.getuid?.() === 0 ? [] : ["sudo", "-n"];
  const apt = async (...parameters) => {
    const [command, ...rest] = [...sudo, "apt-get", ...parameters];
    await run(command, rest, { env: { DEBIAN_FRONTEND: "noninteractive" } });
  };
  const install = (name) => apt("install", "-y", "--no-install-recommends", name);
  try {
    await apt("update");
    await install(PACKAGES[0]).catch(() => install(PACKAGES[1]));
  } catch (error) {
    throw new StepError("no Chromium or Chrome was found and apt could not install one; set CHROMIUM to its path", error.output);
  }
  const installed = findChromium();
  if (!installed) throw new StepError("apt installed Chromium, but it is not on the PATH; set CHROMIUM to its path");
  return installed;
}

/** A headless Chromium driven by playwright-core. */
export async function launch() {
  const { chromium } = await import("playwright-core");
  const executablePath = findChromium();
  if (!executablePath) throw new StepError("no Chromium or Chrome was found; set CHROMIUM to its path");
  return chromium.launch({ executablePath, headless: true, args: FLAGS });
}
