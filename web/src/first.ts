// The first frame shows the head of the page, and nothing is done before it is seen: the program of
// the page takes longer than all until there. Hidden windows have no frames.

let begun = false;
function begin(): void {
  if (!begun) {
    begun = true;
    void import('./main');
  }
}

if (document.hidden) {
  begin();
} else {
  new PerformanceObserver(begin).observe({ type: 'paint', buffered: true });
  // If the browser does not say that it has painted.
  requestAnimationFrame(() => setTimeout(begin, 100));
}
