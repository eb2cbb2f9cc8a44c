// The first frame shows the head of the page; only then is the program read, which takes longer
// than all else until there. index.html has it fetched meanwhile. Hidden windows have no frames.
const begin = () => void import('./main');
if (document.hidden) {
  begin();
} else {
  requestAnimationFrame(() => setTimeout(begin));
}
