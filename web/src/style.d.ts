/** A style as text: build.mjs bundles what it imports. */
declare module '*.css' {
  const text: string;
  export default text;
}
