var i=!1;function e(){i||(i=!0,import("./main.js"))}document.hidden?e():(new PerformanceObserver(e).observe({type:"paint",buffered:!0}),requestAnimationFrame(()=>setTimeout(e,100)));
