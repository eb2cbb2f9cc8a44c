declare module 'temml' {
  const temml: {
    render(
      tex: string,
      place: HTMLElement,
      options?: { displayMode?: boolean; throwOnError?: boolean },
    ): void;
  };
  export default temml;
}
