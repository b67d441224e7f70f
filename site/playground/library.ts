/** All of the package in one module: what `import … from "expline"` is in the playground. */
export * from "expline";
export { default } from "expline";
