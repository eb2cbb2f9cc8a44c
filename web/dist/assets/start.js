var e=()=>{import("./app.js")};document.hidden?e():requestAnimationFrame(()=>setTimeout(e));
