# changeover design v=7 k=3 change=1 kind=linear
D := BlockDesign(7, [
[1,2,7],
[1,2,3],
[1,3,4],
[3,4,7],
[3,4,5],
[3,5,6],
[5,6,7],
[1,5,6],
[2,5,6],
[2,4,6]
]);
