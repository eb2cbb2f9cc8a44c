# changeover design v=6 k=4 change=2 kind=circular
D := BlockDesign(6, [
[1,2,3,4],
[3,4,5,6],
[1,2,5,6]
]);
