/**
 * The largest of numbers, however many: as arguments of one call there may be no more than a stack holds, which is
 * fewer than contours.
 */
export function largest(numbers: readonly number[]): number {
  return numbers.reduce((most, number) => Math.max(most, number), -Infinity);
}
