function [force, stiffness, by_pressure, volume, status] = mckibben_force(pressure, length)
% MCKIBBEN_FORCE  Pull in N at pressures in Pa and lengths in m, numbers or arrays of one size.
%   [force, stiffness, by_pressure, volume, status] = mckibben_force(pressure, length)
%   stiffness: dF/dL in N/m; by_pressure: dF/dP in m2; volume in m3 (slack: at the free contraction);
%   status: 0, or a sum of 1 slack, 2 pressure outside of the box, 4 contraction outside.
% @{facts}
pressure = pressure + 0 * length;
length = length + 0 * pressure;
[~, ~, ~, muscle] = mckibben_coefficients(0);
e = 1 - length / muscle.length;
[c, slope, integral] = mckibben_coefficients(e);
q = pressure / muscle.supply;
[phi, dphi] = functions(q);
pull = total(c, phi);
slack = pull <= 0;
force = max(pull, 0);
stiffness = -total(slope, phi) / muscle.length .* ~slack;
by_pressure = total(c, dphi) / muscle.supply .* ~slack;
status = slack + 2 * (pressure < 0 | pressure > muscle.supply) + 4 * (e < muscle.low | e > muscle.high);
if nargout > 3
    if any(slack(:)) % it hangs at its free contraction: bisection, or the tangent outside of the box
        low = muscle.low + 0 * q; high = muscle.high + 0 * q;
        for k = 1:50
            middle = 0.5 * (low + high);
            cm = mckibben_coefficients(middle);
            over = total(cm, phi) > 0;
            low(over) = middle(over); high(~over) = middle(~over);
        end
        free = 0.5 * (low + high);
        for edge = [muscle.low, muscle.high]
            [ce, se] = mckibben_coefficients(edge + 0 * q);
            pull = total(ce, phi);
            by_e = total(se, phi);
            beyond = (edge == muscle.low & pull <= 0) | (edge == muscle.high & pull >= 0);
            falls = beyond & by_e < 0;
            free(beyond) = edge;
            free(falls) = edge - pull(falls) ./ by_e(falls);
        end
        e(slack) = free(slack);
        [~, ~, integral] = mckibben_coefficients(e);
    end
    volume = total(num2cell(muscle.v), phi) + muscle.length / muscle.supply * total(integral, dphi);
end
end

function [phi, dphi] = functions(q)
knots = [0, 0.15, 0.45];
phi = {1 + 0 * q, q}; dphi = {0 * q, 1 + 0 * q};
for knot = knots
    t = min(max(q - knot, 0), 1 - knot);
    phi{end + 1} = t .* (t + 2 * max(q - 1, 0));
    dphi{end + 1} = 2 * t;
end
end

function out = total(c, phi)
out = 0 * phi{1};
for i = 1:numel(phi)
    out = out + c{i} .* phi{i};
end
end
