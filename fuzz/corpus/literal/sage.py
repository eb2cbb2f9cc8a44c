# changeover design v=6 k=4 change=2 kind=circular
D = IncidenceStructure(6, [
[0,1,2,3],
[2,3,4,5],
[0,1,4,5]
])
