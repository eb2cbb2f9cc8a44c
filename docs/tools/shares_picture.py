#!/usr/bin/env python3
"""Draws docs/img/shares.svg: loads of the busiest worker over the bound, by C·√W/P.

    docs/tools/share_region.py build/release/changeover region.csv 5
    docs/tools/shares_picture.py region.csv > docs/img/shares.svg
"""
import csv
import math
import sys

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 640, 340, 56, 72, 16, 48
LEAST_X, MOST_X, LEAST, MOST = 1 / 16, 9, 1.0, 1.25
COLOURS = {'256': '#440154', '1024': '#21908C', '4096': '#D8A200'}
MUTED = ' fill="#5A5A5A" font-size="11"'


def across(x):
    span = math.log(MOST_X / LEAST_X)
    return LEFT + (WIDTH - LEFT - RIGHT) * math.log(x / LEAST_X) / span


def down(over):
    return TOP + (HEIGHT - TOP - BOTTOM) * (MOST - over) / (MOST - LEAST)


def text(x, y, words, what=''):
    return f'<text x="{x:.1f}" y="{y:.1f}"{what}>{words}</text>'


def main(path):
    with open(path, newline='', encoding='utf-8') as file:
        rows = list(csv.DictReader(file))
    print(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
        f'viewBox="0 0 {WIDTH} {HEIGHT}" role="img" fill="#1A1A1A" font-size="12" '
        'font-family="\'Helvetica Neue\', Arial, \'DejaVu Sans\', sans-serif">'
    )
    print('<title>Loads of the busiest worker over the bound</title>')
    print(
        f'<desc>A dot for each of {len(rows)} numbers of items P, rooms C and workers W: from left '
        'to right C·√W/P, from bottom to top loads over the bound.</desc>'
    )
    print(f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#FFFFFF"/>')
    bold = ' font-size="14" font-weight="bold"'
    print(text(16, 28, 'Loads of the busiest worker over the bound', bold))
    x = 16
    for items, colour in COLOURS.items():
        print(f'<circle cx="{x + 5}" cy="46" r="4" fill="{colour}"/>')
        print(text(x + 14, 50, f'P = {items}', MUTED))
        x += 84
    for step in range(6):
        over = 1 + step * 0.05
        line = f'x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{down(over):.1f}" y2="{down(over):.1f}"'
        print(f'<line {line} stroke="#E2E2E2"/>')
        print(text(LEFT - 8, down(over) + 4, f'{over:.2f}', MUTED + ' text-anchor="end"'))
    for power in range(-4, 4):
        words = f'1/{2 ** -power}' if power < 0 else str(2**power)
        place = HEIGHT - BOTTOM + 18
        print(text(across(2.0**power), place, words, MUTED + ' text-anchor="middle"'))
    middle = (LEFT + WIDTH - RIGHT) / 2
    print(text(middle, HEIGHT - 10, 'C·√W/P', MUTED + ' text-anchor="middle"'))
    for row in rows:
        said = f"P = {row['items']}, C = {row['room']}, W = {row['workers']}: {row['loads']} loads"
        print(
            f'<circle cx="{across(float(row["x"])):.1f}" cy="{down(float(row["over"])):.1f}" '
            f'r="2.6" fill="{COLOURS[row["items"]]}" fill-opacity="0.7"><title>{said}, bound '
            f'{row["bound"]}</title></circle>'
        )
    print('</svg>')


if __name__ == '__main__':
    main(sys.argv[1])
